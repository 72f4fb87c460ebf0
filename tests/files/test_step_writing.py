"""STEP files out: what faces are, how parts stand, what the header says, what is refused."""

import re
import sys

import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.Geom import (
    Geom_BSplineSurface,
    Geom_ConicalSurface,
    Geom_CylindricalSurface,
    Geom_Plane,
    Geom_SphericalSurface,
    Geom_SurfaceOfLinearExtrusion,
    Geom_SurfaceOfRevolution,
    Geom_ToroidalSurface,
)
from OCP.Interface import Interface_Static
from OCP.TopAbs import TopAbs_SHELL

import gearwright as gw
from gearwright.errors import FileError, GeometryError, MachineError

from ..examples import README_PAIR
from . import occt

SPIRAL = {
    "teeth": (16, 20),
    "module": 12.7,
    "face_width": 38.1,
    "working_depth": 20.32,
    "whole_depth": 21.59,
    "gear_addendum": 10.16,
    "root": "radial",
    "ends": "spherical",
    "trace": "logarithmic",
    "spiral_angle": 35.0,
}
"""Al-Daccak 1989, table 3.1, in millimetres."""


@pytest.fixture(scope="module")
def spiral(tmp_path_factory):
    pair = gw.BevelPair(**SPIRAL)
    path = tmp_path_factory.mktemp("spiral") / "pair.step"
    pair.save(path)
    return pair, path


def kinds(shape):
    return sorted({type(surface) for surface in occt.surfaces(shape)}, key=str)


def test_the_default_tolerance_of_the_spiral_pair_is_below_a_tenth_of_a_micrometre(spiral):
    pair, path = spiral
    assert pair.pinion.smooth_tolerance == pytest.approx(63.5e-6)
    assert "within 6.35e-05 mm" in path.read_text()


def test_the_spiral_angle_measured_on_the_file(spiral):
    # along the pitch cone, tan ψ = sin γ dφ / d ln R; points of it are sought on the file's own splines
    pinion = occt.solids(occt.read(spiral[1]))[0]
    gamma = np.arctan2(16.0, 20.0)
    found = []
    for surface in occt.surfaces(pinion):
        if isinstance(surface, Geom_BSplineSurface):
            ends = [crossing(surface, gamma, v) for v in (0.0, 0.5, 1.0)]
            if all(end is not None for end in ends):
                radii = np.array([np.linalg.norm(p) for p in ends])
                turns = np.unwrap([np.arctan2(p[1], p[0]) for p in ends])
                found += np.degrees(np.arctan(np.sin(gamma) * np.diff(turns) / np.diff(np.log(radii)))).tolist()
    assert len(found) == 2 * 2 * 16  # two flanks of every tooth, halves of the face
    assert np.abs(np.abs(found) - 35.0).max() < 1e-5


def crossing(surface, polar, v):
    """The point of the line v of a surface at a polar angle; None where it does not cross."""
    u = np.linspace(0.0, 1.0, 41)

    def angle(at):
        point = surface.Value(float(at), v)
        return np.arctan2(np.hypot(point.X(), point.Y()), point.Z()) - polar

    angles = np.array([angle(at) for at in u])
    (where,) = np.nonzero(angles[:-1] * angles[1:] < 0.0)
    if len(where) != 1:
        return None
    low, high = u[where[0]], u[where[0] + 1]
    for _ in range(60):
        middle = (low + high) / 2.0
        low, high = (middle, high) if angle(low) * angle(middle) > 0.0 else (low, middle)
    point = surface.Value(float(low), v)
    return np.array([point.X(), point.Y(), point.Z()])


def test_a_pair_is_an_assembly_of_named_and_coloured_members_in_mesh(spiral):
    pair, path = spiral
    text = path.read_text()
    assert text.count("NEXT_ASSEMBLY_USAGE_OCCURRENCE(") == 2
    assert {"pinion", "gear", "pair"} <= set(re.findall(r"PRODUCT\('(\w+)'", text))
    assert text.count("COLOUR_RGB") == 2
    for member, solid, placement in zip(
        (pair.pinion, pair.gear), occt.solids(occt.read(path)), pair.placements(), strict=True
    ):
        _, centroid, _ = occt.properties(solid)
        wanted = placement[:3, :3] @ member.properties().centroid + placement[:3, 3]
        assert np.allclose(centroid, wanted, rtol=0.0, atol=1e-5)


def test_a_pair_is_written_at_a_turn(tmp_path):
    # a bore off nothing would not show a turn: a keyway does
    pair = gw.GearPair(kind="spur", teeth=(17, 23), module=2.0, face_width=8.0, bore=(10.0, 12.0), keyway="din-6885")
    pair.save(tmp_path / "turned.step", turn=40.0)
    for member, solid, placement in zip(
        (pair.pinion, pair.gear), occt.solids(occt.read(tmp_path / "turned.step")), pair.placements(40.0), strict=True
    ):
        _, centroid, _ = occt.properties(solid)
        wanted = placement[:3, :3] @ member.properties().centroid + placement[:3, 3]
        assert np.allclose(centroid, wanted, rtol=0.0, atol=1e-6)


def test_faces_are_what_they_are_named_in_a_catalogue(tmp_path):
    gear = gw.SpurGear(teeth=20, module=2.0, face_width=10.0, bore=8.0)
    cylinders = [s for s in occt.surfaces(gear.to_ocp()) if isinstance(s, Geom_CylindricalSurface)]
    radii = sorted({round(s.Radius(), 9) for s in cylinders})
    assert radii == [4.0, 17.5, 22.0]  # bore, roots, tips
    assert kinds(gear.to_ocp()) == sorted([Geom_CylindricalSurface, Geom_Plane, Geom_SurfaceOfLinearExtrusion], key=str)


def test_every_surface_of_revolution():
    outline = gw.Section.polygon([(2, 0), (6, 0), (6, 2), (4, 4), (2, 4)])
    found = occt.surfaces(gw.revolve(outline).to_ocp())
    (cone,) = (s for s in found if isinstance(s, Geom_ConicalSurface))
    assert abs(cone.SemiAngle()) == pytest.approx(np.pi / 4.0)
    assert sorted(s.Radius() for s in found if isinstance(s, Geom_CylindricalSurface)) == pytest.approx([2.0, 6.0])
    (torus,) = occt.surfaces(gw.revolve(gw.Section.circle(1.0, centre=(5.0, 0.0))).to_ocp())
    assert isinstance(torus, Geom_ToroidalSurface)
    assert (torus.MajorRadius(), torus.MinorRadius()) == pytest.approx((5.0, 1.0))
    waves = gw.Section.spline([(2, 0), (3, 0.2), (2.8, 1.1), (3.1, 2.0), (2.1, 1.9), (1.8, 1.0)])
    assert kinds(gw.revolve(waves, 130.0).to_ocp()) == sorted([Geom_Plane, Geom_SurfaceOfRevolution], key=str)


def test_ends_of_bevel_gears_are_spheres_and_cones():
    gear = gw.BevelPair(**SPIRAL).pinion
    ends = [s for s in occt.surfaces(gear.to_ocp()) if isinstance(s, Geom_SphericalSurface)]
    outer = gear.sizes()["cone_distance"].value
    assert sorted(s.Radius() for s in ends) == pytest.approx([outer - 38.1, outer])
    conical = gw.BevelGear(teeth=20, module=4.0, pitch_angle=45.0, face_width=15.0, bore=12.0)
    assert Geom_ConicalSurface in kinds(conical.to_ocp())


def test_a_void_is_a_shell_of_its_own():
    ring = gw.Section.polygon([(4, -2), (8, -2), (8, 2), (4, 2)], holes=[[(5, -1), (5, 1), (7, 1), (7, -1)]])
    shape = gw.revolve(ring).to_ocp()
    (solid,) = occt.solids(shape)
    assert len(list(occt.subshapes(solid, TopAbs_SHELL))) == 2
    assert occt.is_valid(shape)
    # Pappus: areas 16 and 4 about circles of radius 6
    assert occt.properties(shape)[0] == pytest.approx(2.0 * np.pi * 6.0 * (16.0 - 4.0), rel=1e-12)


def test_bodies_apart_are_several_solids():
    box = gw.extrude(gw.Section.rectangle(2.0, 1.0), 3.0)
    shape = (box + box.moved(np.eye(3), (5.0, 0.0, 0.0))).to_ocp()
    assert [occt.properties(solid)[0] for solid in occt.solids(shape)] == pytest.approx([6.0, 6.0], rel=1e-12)


def test_inches_are_written_as_inches(tmp_path):
    pair = gw.BevelPair(**README_PAIR)
    pair.pinion.save(tmp_path / "pinion.step")
    text = (tmp_path / "pinion.step").read_text()
    assert "'INCH'" in text
    assert occt.properties(occt.read(tmp_path / "pinion.step"))[0] == pytest.approx(
        pair.pinion.properties().volume * 25.4**3, rel=1e-7
    )
    # and points are numbers of inches: the outer cone distance is 6.4
    numbers = re.findall(r"CARTESIAN_POINT\('',\(([^)]*)\)", text)
    assert max(abs(float(x)) for point in numbers for x in point.split(",")) < 25.4


@pytest.mark.parametrize(
    ("schema", "said"), [("AP214", "AUTOMOTIVE_DESIGN"), ("AP242", "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING")]
)
def test_schemas(tmp_path, schema, said):
    gw.extrude(gw.Section.circle(1.0), 2.0).save(tmp_path / "a.step", step_schema=schema)
    assert said in re.sub(r"\s", "", (tmp_path / "a.step").read_text())


def test_the_header_says_what_wrote_it_and_how_near_it_is(tmp_path):
    gw.extrude(gw.Section.circle(1.0), 2.0, twist=90.0, scale=(1.0, 0.5)).save(tmp_path / "part.stp", tolerance=2e-3)
    head = (tmp_path / "part.stp").read_text().partition("DATA;")[0]
    assert "smooth faces within 0.002 mm of the exact surfaces" in head
    assert f"Gearwright {gw.__version__}" in head


def test_a_coarser_tolerance_makes_a_smaller_file(tmp_path):
    gear = gw.HelicalGear(teeth=13, module=3.0, face_width=20.0, helix_angle=25.0)
    sizes = []
    for tolerance in (1e-2, 1e-4, 1e-6):
        gear.save(tmp_path / "gear.step", tolerance=tolerance)
        sizes.append((tmp_path / "gear.step").stat().st_size)
    assert sizes[0] < sizes[1] < sizes[2]


def test_settings_of_other_programs_stay_as_they_were(tmp_path):
    gw.extrude(gw.Section.circle(1.0), 2.0).save(tmp_path / "a.step")
    Interface_Static.SetCVal_s("write.step.unit", "KM")
    gw.extrude(gw.Section.circle(1.0), 2.0).save(tmp_path / "b.step", length_unit="in")
    assert Interface_Static.CVal_s("write.step.unit") == "KM"
    Interface_Static.SetCVal_s("write.step.unit", "MM")


@pytest.mark.parametrize("tolerance", [0.0, -1.0, np.nan, np.inf, 1e-15])
def test_tolerances_that_are_none_or_cannot_be_met(tmp_path, tolerance):
    solid = gw.extrude(gw.Section.circle(10.0), 5.0, twist=30.0, scale=(1.0, 0.9))
    with pytest.raises(GeometryError, match=r"No smooth faces have this tolerance:\n  tolerance = "):
        solid.save(tmp_path / "a.step", tolerance=tolerance)
    assert not list(tmp_path.iterdir())


def test_what_is_no_step_is_refused(tmp_path):
    solid = gw.extrude(gw.Section.circle(1.0), 2.0)
    for arguments, said in (
        ({"path": "a.stl", "step_schema": "AP242"}, "a schema of STEP files"),
        ({"path": "a.step", "step_schema": "AP203"}, "choose AP214 or AP242"),
        ({"path": "a.step", "length_unit": "furlong"}, "choose one of um, mm"),
        ({"path": "a.step", "length_unit": None}, "give a length_unit"),
        ({"path": "nowhere/a.step"}, "there is no folder"),
    ):
        with pytest.raises(FileError, match=said):
            solid.save(**{**arguments, "path": tmp_path / arguments["path"]})
    assert not list(tmp_path.iterdir())


def test_a_full_disk_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "a.step"
    path.write_text("the old one")
    monkeypatch.setattr("os.fsync", lambda _: (_ for _ in ()).throw(OSError(28, "No space left on device")))
    with pytest.raises(MachineError, match="No space left"):
        gw.extrude(gw.Section.circle(1.0), 2.0).save(path)
    assert path.read_text() == "the old one"
    assert [p.name for p in tmp_path.iterdir()] == ["a.step"]


def test_without_the_extra(tmp_path, monkeypatch):
    from gearwright.files.step.kernel import kernel

    for module in [name for name in sys.modules if name.split(".")[0] == "OCP"]:
        monkeypatch.setitem(sys.modules, module, None)
    kernel.cache_clear()
    with pytest.raises(MachineError, match=r"pip install 'gearwright\[step\]'"):
        gw.extrude(gw.Section.circle(1.0), 2.0).save(tmp_path / "a.step")
    kernel.cache_clear()
    assert not list(tmp_path.iterdir())


def test_a_pair_is_a_compound_in_mesh():
    pair = gw.GearPair(kind="spur", teeth=(17, 23), module=2.0, face_width=8.0)
    first, second = occt.solids(pair.to_ocp(turn=5.0))
    assert occt.properties(first)[1] == pytest.approx([0.0, 0.0, 4.0], abs=1e-6)
    assert occt.properties(second)[1] == pytest.approx([40.0, 0.0, 4.0], abs=1e-6)


def test_seams_meet_edges_that_others_cut(tmp_path):
    # the back cone's seam ends inside the circle around the hub, which the hub's own faces share
    gear = gw.BevelGear(teeth=17, module=3.0, mate_teeth=25, face_width=12.0, bore=12.0)
    shape = gear.to_ocp()
    assert occt.is_valid(shape)
    assert all(count == 2 for _, count in occt.edge_uses(shape))
    assert all(BRep_Tool.Tolerance_s(edge) < 2e-5 for edge, _ in occt.edge_uses(shape))
