"""Law of all elements that have a plane section: what is cut from a DXF closes, entity by entity."""

import ezdxf
import numpy as np

from ..examples import built, every_part

ROUNDING = 16.0 * float(np.finfo(float).eps)
"""Of the coordinates: where two arcs meet, each has its own centre and radius, which are rounded."""


def ends(entity):
    """The two ends (2, 2) of an entity as a program finds them; None of a closed one."""
    match entity.dxftype():
        case "LINE":
            points = [entity.dxf.start, entity.dxf.end]
        case "ARC":
            points = [entity.start_point, entity.end_point]
        case "SPLINE":
            points = [entity.control_points[0], entity.control_points[-1]]
        case "ELLIPSE" if abs(entity.dxf.end_param - entity.dxf.start_param) < 2.0 * np.pi * (1.0 - 1e-12):
            points = [entity.start_point, entity.end_point]
        case _:
            return None
    return np.array([tuple(point)[:2] for point in points])


@every_part
def test_each_end_in_a_dxf_is_one_other_end_and_the_audit_is_clean(part, tmp_path):
    element = built(part)
    if element.profile is None:
        return
    element.save_drawing(tmp_path / "a.dxf")
    document = ezdxf.readfile(tmp_path / "a.dxf")
    audit = document.audit()
    assert (audit.errors, audit.fixes) == ([], [])
    entities = list(document.modelspace())
    assert {entity.dxf.layer for entity in entities} == {"profile"}
    open_ones = [found for entity in entities if (found := ends(entity)) is not None]
    if not open_ones:
        return
    points = np.concatenate(open_ones)
    size = float(np.abs(points).max())
    distances = np.linalg.norm(points[:, None] - points[None], axis=2)
    np.fill_diagonal(distances, np.inf)
    assert distances.min(axis=1).max() <= ROUNDING * size
    assert np.all((distances <= ROUNDING * size).sum(axis=1) == 1), "an end at which not exactly two entities meet"
