import numpy as np
import pytest

from gearwright.curves.arc import Arc
from gearwright.curves.line import Line
from gearwright.errors import GeometryError
from gearwright.motions.ends import between
from gearwright.motions.revolution import Revolution
from gearwright.motions.straight import Straight
from gearwright.sections.loop import Loop
from gearwright.sections.plane import Section
from gearwright.solids.swept import Swept


def circle(radius: float, centre: tuple[float, float] = (0.0, 0.0), sense: int = 1) -> Loop:
    return Loop(curves=(Arc(radius=radius, centre=centre, interval=(0.0, sense * 2.0 * np.pi)),))


def triangle(*corners: tuple[float, float]) -> Section:
    curves = tuple(Line(first=a, last=b) for a, b in zip(corners, (*corners[1:], corners[0]), strict=True))
    return Section(loops=(Loop(curves=curves),))


def test_ends_in_the_wrong_order_are_refused():
    with pytest.raises(GeometryError, match="must end beyond its start, 5, not at 0"):
        Swept(section=Section(loops=(circle(1.0),)), motion=Straight(), ends=between(5.0, 0.0))


def test_a_section_across_the_axis_is_refused_with_the_place():
    with pytest.raises(
        GeometryError,
        match=r"\[-1.0, 0.0\] at azimuth .* it lies 1 beyond the axis x = 0; keep the section on the side of",
    ):
        Swept(section=Section(loops=(circle(2.0, (1.0, 0.0)),)), motion=Revolution(), ends=between(-1.0, 0.0))


@pytest.mark.parametrize(
    ("section", "point"),
    [
        (lambda: Section.circle(1.0, (1.0, 0.0)), [0.0, 0.0]),
        (lambda: Section.circle(0.3, (0.3, 2.0)), [0.0, 2.0]),
        (lambda: Section.polygon([(0, 0), (1, -1), (2, 0), (1, 1)]), [0.0, 0.0]),
        (lambda: Section.spline([(0, 0), (1, -1), (2, 0), (1, 1)]), None),
        (lambda: Section.polygon([(0, 0), (2, 0), (2, 4), (0, 4), (1, 3), (0, 2), (1, 1)]), [0.0, 0.0]),
    ],
)
def test_a_section_that_touches_the_axis_at_a_point_is_refused(section, point):
    with pytest.raises(GeometryError, match="touches the axis at this one point") as caught:
        Swept(section=section(), motion=Revolution(), ends=between(-1.0, 0.0))
    assert point is None or f"section point {point}" in str(caught.value)


def test_a_section_may_run_along_the_axis():
    arc = Arc(radius=2.0, interval=(-np.pi / 2, np.pi / 2))
    ball = Section.outline([arc, Line(first=(0.0, 2.0), last=(0.0, -2.0))])
    for section in (ball, Section.rectangle(2.0, 1.0, (1.0, 0.0)), Section.polygon([(0, 0), (1, 0), (0, 2)])):
        solid = Swept(section=section, motion=Revolution(), ends=between(-2.0 * np.pi, 0.0))
        assert solid.polyhedron(0.01).validity().valid


def test_more_than_a_turn_is_refused():
    with pytest.raises(GeometryError, match=r"a revolution of 1145\.92° would run into itself"):
        Swept(section=Section(loops=(circle(1.0, (5.0, 0.0)),)), motion=Revolution(), ends=between(0.0, 20.0))


def test_holes_larger_than_the_outline_are_refused():
    with pytest.raises(GeometryError, match="the holes take more than the outer loop encloses"):
        Section(loops=(circle(1.0), circle(3.0, sense=-1)))


def test_no_loops_and_no_curves_are_refused():
    with pytest.raises(GeometryError, match="at least the outer one is needed"):
        Section(loops=())
    with pytest.raises(GeometryError, match="at least one of each is needed"):
        Loop(curves=())


@pytest.mark.parametrize("angle", [90.0, 360.0])
def test_a_cone_revolved_with_its_axis_in_the_section(angle):
    # right-angled triangle with one side on the axis: radius 3, height 4
    cone = Swept(
        section=triangle((0.0, 0.0), (3.0, 0.0), (0.0, 4.0)),
        motion=Revolution(),
        ends=between(-np.radians(angle), 0.0),
    )
    volume = 12.0 * np.pi * angle / 360.0
    assert cone.moments.volume == pytest.approx(volume, rel=1e-14)
    polyhedron = cone.polyhedron(1e-3)
    assert polyhedron.validity().valid
    assert polyhedron.properties().volume == pytest.approx(volume, rel=2e-3)
    about_axis = cone.properties().inertia[2, 2]
    assert about_axis == pytest.approx(0.3 * volume * 9.0, rel=1e-13)
    assert cone.properties().bounding_box == pytest.approx(
        np.array([[0.0 if angle == 90 else -3.0] * 2 + [0.0], [3.0, 3.0, 4.0]]), abs=1e-9
    )
