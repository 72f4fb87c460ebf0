"""One file on several workers gives what it gives in one process, to the last bit."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from gearwright import Polyhedron
from gearwright.errors import FileError, GeometryError
from gearwright.moments import summation
from gearwright.solids.streamed import stream_properties
from gearwright.studies import reduction

from .. import shapes


@pytest.fixture(scope="module")
def client():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of its own dependencies
        from dask.distributed import Client

        with Client(processes=False, n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
            yield client


def test_workers_change_no_bit(client, tmp_path, monkeypatch):
    monkeypatch.setattr(reduction, "_CHUNKS", 2)
    vertices, triangles = shapes.torus(400, 300)
    path = tmp_path / "torus.stl"
    Polyhedron(vertices, triangles).save(path)
    assert len(triangles) > 6 * summation.CHUNK
    alone = stream_properties(path, 7.0)
    found = reduction.stream_properties_on_dask(path, client, 7.0)
    assert found.volume == alone.volume
    assert found.mass == 7.0 * alone.volume
    np.testing.assert_array_equal(found.central_second, alone.central_second)
    np.testing.assert_array_equal(found.bounding_box, alone.bounding_box)


def test_a_file_that_does_not_close_is_refused(client, tmp_path):
    vertices, triangles = shapes.torus(20, 10)
    path = tmp_path / "open.stl"
    Polyhedron(vertices, triangles[1:]).save(path)
    with pytest.raises(GeometryError, match=r"open.stl does not bound a solid:\n  closure residual .*check"):
        reduction.stream_properties_on_dask(path, client)
    with pytest.raises(FileError, match="there is no such file"):
        reduction.stream_properties_on_dask(tmp_path / "none.stl", client)
