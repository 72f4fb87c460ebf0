"""How far a text rounds coordinates is seen from its numbers."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.files.obj import reader as obj

from .random_polyhedra import prism


def rounding(form, scale=20.0, points=None):
    shape = prism(37, scale)
    points = np.array(shape.vertices) * 0.987654321 + 1e-3 if points is None else points
    lines = ["v " + " ".join(form(x) for x in point) for point in points.tolist()]
    (body,) = obj.parse("\n".join([*lines, "f 1 2 3", "f " + " ".join(map(str, range(1, 75)))]).encode(), "x").bodies
    written = body.vertices
    return body.rounding, np.abs(written - points).max()


@pytest.mark.parametrize(
    "form", ["{:.6f}", "{:.3f}", "{:.2f}", "{:.4f}", "{:.6g}", "{:.8g}", "{:.6e}", "{:.12f}", "{:.10g}"]
)
@pytest.mark.parametrize("scale", [0.3, 20.0, 777.0])
def test_at_least_the_errors_and_little_more(form, scale):
    found, error = rounding(form.format, scale)
    assert error <= found + np.spacing(2 * scale)  # the double nearest to a decimal is not the decimal
    assert found <= 15 * error


@pytest.mark.parametrize(
    ("form", "scale", "expected"),
    [("{:.6f}", 20.0, 5e-7), ("{:.3f}", 777.0, 5e-4), ("{:.6g}", 777.0, 5e-4), ("{:.6e}", 0.5, 5e-8)],
)
def test_half_a_unit_in_the_last_place_of_the_largest(form, scale, expected):
    assert rounding(form.format, scale)[0] == pytest.approx(expected, rel=1e-12)


def test_noughts_left_away_do_not_hide_rounding():
    found, error = rounding(lambda x: f"{x:.6f}".rstrip("0").rstrip("."))
    assert error <= found <= 15 * error


@pytest.mark.parametrize("form", [repr, "{:.17g}".format, "{:.16e}".format, "{:.20f}".format])
def test_double_precision_is_not_rounded(form):
    assert rounding(form)[0] == 0.0


@pytest.mark.parametrize("form", [repr, "{:.9g}".format, "{:.17g}".format, "{:.10f}".format])
def test_single_precision_is_seen(form):
    points = (np.array(prism(37, 20.0).vertices) * 0.987654321).astype(np.float32)
    found, _ = rounding(form, points=points.astype(float))
    assert found == pytest.approx(np.spacing(np.abs(points).max()) / 2)


@pytest.mark.parametrize("form", [repr, "{:.1f}".format, "{:.3f}".format, "{:g}".format])
@pytest.mark.parametrize("step", [0.25, 0.5, 1.0, 2.5])
def test_lengths_as_people_write_them_are_exact(form, step):
    points = np.round(np.array(prism(37, 9.0).vertices)) * step
    assert rounding(form, points=points)[0] == 0.0
