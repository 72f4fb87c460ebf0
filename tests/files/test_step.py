"""STEP files: solids made by Open CASCADE itself, against closed forms; everything that can be wrong with a file."""

from __future__ import annotations

import math
import sys
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeWire
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCone,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakePrism,
    BRepPrimAPI_MakeSphere,
    BRepPrimAPI_MakeTorus,
)
from OCP.GeomAPI import GeomAPI_Interpolate
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf, gp_Vec
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDocStd import TDocStd_Document
from OCP.TopLoc import TopLoc_Location
from OCP.XCAFDoc import XCAFDoc_DocumentTool
from scipy.integrate import quad

from gearwright.errors import FileError, MachineError
from gearwright.files.contents import Contents
from gearwright.files.instances import placed
from gearwright.files.step import exchange, faces, kernel, quadrature, reading, solids
from gearwright.moments.faces import Corners
from gearwright.solids.model import Model
from gearwright.solids.polyhedron import Polyhedron


def written(path, fill):
    """The bytes of a STEP file of a document that `fill` fills."""
    kernel.kernel()  # which silences what the writer prints
    document = TDocStd_Document(TCollection_ExtendedString("test"))
    fill(XCAFDoc_DocumentTool.ShapeTool_s(document.Main()))
    writer = STEPCAFControl_Writer()
    writer.SetNameMode(True)
    assert writer.Transfer(document)
    writer.Write(str(path))
    return path.read_bytes()


def named(tool, shape, name):
    label = tool.AddShape(shape, False)
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(name))
    return label


def file_of(path, shape, name="part"):
    return written(path, lambda tool: named(tool, shape, name))


def in_one_process(data):
    """As `reading.parse` does, without the second process that crashes in place of this one."""
    found = exchange.unpacked(exchange.packed(solids.found_in(data, "part.step")))
    bodies = tuple(placed("part.step", ((found.bodies[number], matrix) for number, matrix in found.placements)))
    return Contents(bodies=bodies, length_unit="mm", remarks=found.remarks)


def polyhedron(body):
    return Polyhedron(body.vertices, Corners(body.indices, body.offsets))


def spline_curve(count=7):
    """A closed spline through points about the origin."""
    points = kernel._collection("HArray1_gp_Pnt", "TColgp", "TColgp_HArray1OfPnt")(1, count)
    for k in range(count):
        angle, radius = 2 * math.pi * k / count, 10 + 3 * math.cos(6 * math.pi * k / count)
        points.SetValue(k + 1, gp_Pnt(radius * math.cos(angle), radius * math.sin(angle), 0))
    interpolation = GeomAPI_Interpolate(points, True, 1e-9)
    interpolation.Perform()
    return interpolation.Curve()


def spline_prism(height=20):
    wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline_curve()).Edge()).Wire()
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, height)).Shape()


@cache
def spline_area():
    """½ ∮ (x dy − y dx), span by span."""
    curve = spline_curve()

    def integrand(u):
        point, derivative = gp_Pnt(), gp_Vec()
        curve.D1(u, point, derivative)
        return 0.5 * (point.X() * derivative.Y() - point.Y() * derivative.X())

    knots = [curve.Knot(k) for k in range(1, curve.NbKnots() + 1)]
    return sum(quad(integrand, a, b, epsabs=1e-12)[0] for a, b in pairwise(knots))


# volume, centroid, diagonal of the second moment about it; None where no closed form is at hand
SHAPES = {
    "box": (lambda: BRepPrimAPI_MakeBox(2, 3, 5).Shape(), 30, (1, 1.5, 2.5), (10, 22.5, 62.5)),
    "sphere": (
        lambda: BRepPrimAPI_MakeSphere(7).Shape(), 4 / 3 * math.pi * 343, (0, 0, 0), (4 / 15 * math.pi * 7**5,) * 3
    ),
    "half sphere": (
        lambda: BRepPrimAPI_MakeSphere(7, 0, math.pi / 2).Shape(), 2 / 3 * math.pi * 343, (0, 0, 21 / 8), None
    ),
    "cylinder": (
        lambda: BRepPrimAPI_MakeCylinder(3, 8).Shape(), 72 * math.pi, (0, 0, 4),
        (162 * math.pi, 162 * math.pi, 384 * math.pi),
    ),
    "cone": (
        lambda: BRepPrimAPI_MakeCone(4, 0, 6).Shape(), 32 * math.pi, (0, 0, 1.5),
        (76.8 * math.pi, 76.8 * math.pi, 43.2 * math.pi),
    ),
    "frustum": (lambda: BRepPrimAPI_MakeCone(4, 2, 6).Shape(), 56 * math.pi, (0, 0, 33 / 14), None),
    "torus": (lambda: BRepPrimAPI_MakeTorus(9, 2).Shape(), 72 * math.pi**2, (0, 0, 0), None),
    "spline prism": (spline_prism, None, None, None),
}  # fmt: skip


@pytest.fixture(scope="module")
def read(tmp_path_factory):
    @cache
    def read(name):
        path = tmp_path_factory.mktemp("step") / "shape.step"
        return in_one_process(file_of(path, SHAPES[name][0](), name))

    return read


@pytest.mark.parametrize("name", SHAPES)
def test_solids_are_closed_and_within_the_tolerance(read, name):
    volume = SHAPES[name][1] or 20 * spline_area()
    contents = read(name)
    (body,) = contents.bodies
    assert (body.name, contents.length_unit) == (name, "mm")
    found = polyhedron(body)
    assert found.validity().valid
    assert (np.diff(np.sort(found.faces)) > 0).all()
    diagonal = np.linalg.norm(found.vertices.max(axis=0) - found.vertices.min(axis=0))
    properties = found.properties()
    # a layer of the tolerance all over, and of twice the diagonal as the kernel bounds splines by their poles
    assert abs(properties.volume - volume) <= 2 * faces.DEFLECTION * diagonal * properties.area
    assert (name == "box") == (abs(properties.volume / volume - 1) < 1e-14)
    assert len(np.unique(found.vertices, axis=0)) == len(found.vertices)
    assert "smooth faces read as triangles within" in contents.remarks[0]


@pytest.mark.parametrize("name", SHAPES)
def test_smooth_properties_are_those_of_the_smooth_shape(read, name):
    _, volume, centroid, second_moment = SHAPES[name]
    smooth = read(name).bodies[0].smooth
    assert smooth.volume == pytest.approx(volume or 20 * spline_area(), rel=1e-9)
    if centroid is not None:
        np.testing.assert_allclose(smooth.centroid, centroid, atol=1e-9)
    if second_moment is not None:
        np.testing.assert_allclose(smooth.second_moment, np.diag(second_moment), rtol=1e-9, atol=1e-9)
    of_polyhedron = polyhedron(read(name).bodies[0]).properties()
    np.testing.assert_allclose(smooth.centroid, of_polyhedron.centroid, atol=0.01)
    trace = np.trace(of_polyhedron.central_inertia)
    np.testing.assert_allclose(np.trace(smooth.second_moment), trace / 2, rtol=0.01)


def test_points_lie_on_the_smooth_faces(read):
    sphere, torus = (read(name).bodies[0].vertices for name in ("sphere", "torus"))
    np.testing.assert_allclose(np.linalg.norm(sphere, axis=1), 7, rtol=1e-12)
    ring = np.hypot(np.hypot(torus[:, 0], torus[:, 1]) - 9, torus[:, 2])
    np.testing.assert_allclose(ring, 2, rtol=1e-12)


def assembly(tool):
    """A rod, placed twice, the second time turned about z by 90° and shifted, and a box, all below one root."""
    turn = gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), math.pi / 2)
    turn.SetTranslationPart(gp_Vec(100, 0, 0))
    root = tool.NewShape()
    TDataStd_Name.Set_s(root, TCollection_ExtendedString("machine"))
    rod = named(tool, BRepPrimAPI_MakeBox(10, 1, 1).Shape(), "rod")
    box = named(tool, BRepPrimAPI_MakeBox(2, 2, 2).Shape(), "box")
    for label, place in ((rod, gp_Trsf()), (rod, turn), (box, gp_Trsf())):
        tool.AddComponent(root, label, TopLoc_Location(place))
    tool.UpdateAssemblies()


def test_assemblies_are_expanded(tmp_path):
    (tmp_path / "machine.STEP").write_bytes(written(tmp_path / "x", assembly))
    model = Model.load(tmp_path / "machine.STEP")
    assert list(model.bodies) == ["rod", "rod (2)", "box"]
    second = model.bodies["rod (2)"]
    np.testing.assert_allclose(second.vertices.min(axis=0), [99, 0, 0], atol=1e-12)
    np.testing.assert_allclose(second.vertices.max(axis=0), [100, 10, 1], atol=1e-12)
    assert second.properties().volume == pytest.approx(10, rel=1e-13)
    body = in_one_process(written(tmp_path / "x", assembly)).bodies[1]
    np.testing.assert_allclose(body.smooth.centroid, [99.5, 5, 0.5], atol=1e-12)
    np.testing.assert_allclose(np.diag(body.smooth.second_moment), [10 / 12, 1000 / 12, 10 / 12], rtol=1e-12)


MILLIMETRE = b"( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )"
INCH = b"""( CONVERSION_BASED_UNIT('INCH',#9001) LENGTH_UNIT() NAMED_UNIT(#9002) );
#9001 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#9003);
#9002 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);
#9003 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )"""


def test_inches_become_millimetres(tmp_path):
    data = file_of(tmp_path / "x", BRepPrimAPI_MakeBox(1, 2, 3).Shape())
    assert data.count(MILLIMETRE) == 1
    millimetres, inches = in_one_process(data), in_one_process(data.replace(MILLIMETRE, INCH))
    assert inches.length_unit == millimetres.length_unit == "mm"
    assert "lengths in inch converted to millimetres" in inches.remarks
    assert not any("converted" in remark for remark in millimetres.remarks)
    np.testing.assert_allclose(inches.bodies[0].vertices.max(axis=0), [25.4, 50.8, 76.2], rtol=1e-12)
    np.testing.assert_allclose(millimetres.bodies[0].vertices.max(axis=0), [1, 2, 3], rtol=1e-12)
    assert inches.bodies[0].smooth.volume == pytest.approx(6 * 25.4**3, rel=1e-12)


def test_surfaces_of_no_solid_are_left_out(tmp_path):
    wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline_curve()).Edge()).Wire()
    face = BRepBuilderAPI_MakeFace(wire).Face()
    with pytest.raises(FileError, match=r"without a solid.*1 faces of no solid left out.*join its surfaces"):
        in_one_process(file_of(tmp_path / "x", face))


def test_a_quadrature_that_the_triangles_contradict_is_not_used(tmp_path, monkeypatch):
    def wrong(solid):
        right = quadrature.smooth_properties(solid)
        return right.mapped(np.eye(3) * 1.01, np.zeros(3))

    monkeypatch.setattr(solids, "smooth_properties", wrong)
    contents = in_one_process(file_of(tmp_path / "x", BRepPrimAPI_MakeSphere(7).Shape()))
    assert contents.bodies[0].smooth is None
    assert any("the quadrature is not used" in remark for remark in contents.remarks)


def test_plain_gauss_is_not_used_on_splines(read):
    """What Open CASCADE gives by default is wrong by more than 1e-3 here; what is used is not."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    plain = GProp_GProps()
    BRepGProp.VolumeProperties_s(spline_prism(), plain)
    assert abs(plain.Mass() / (20 * spline_area()) - 1) > 1e-3
    smooth = read("spline prism").bodies[0].smooth
    assert smooth.centroid[2] == pytest.approx(10, rel=1e-9)
    assert smooth.second_moment[2, 2] == pytest.approx(spline_area() * 20**3 / 12, rel=1e-8)


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda data: b"", 'not a STEP file, which begins with "ISO-10303-21;"'),
        (lambda data: b"junk", "not a STEP file"),
        (lambda data: data[: len(data) // 2], "does not end with"),
        (lambda data: data[: len(data) // 2] + b"\nENDSEC;\nEND-ISO-10303-21;\n", "STEP file"),
        (lambda data: data.replace(b"(0.,0.,0.));", b"(0.,0.,0.", 1), "not a whole STEP file: Line"),
        (lambda data: b"ISO-10303-21;\nEND-ISO-10303-21;\n", "cannot read this STEP file"),
        (lambda data: data[: data.index(b"DATA;")] + b"DATA;\nENDSEC;\nEND-ISO-10303-21;\n", "STEP file"),
    ],
)
def test_refusals(tmp_path, spoil, said, capfd):
    data = file_of(tmp_path / "x", BRepPrimAPI_MakeBox(1, 1, 1).Shape())
    with pytest.raises(FileError, match=said) as caught:
        reading.parse(spoil(data), "some/part.step")
    assert str(caught.value).startswith("some/part.step: ")
    assert capfd.readouterr() == ("", "")


def test_faulty_entities_are_remarked(tmp_path):
    """A product's context that is none; the shape does not need it."""
    data = file_of(tmp_path / "x", BRepPrimAPI_MakeBox(1, 1, 1).Shape())
    start = data.index(b"PRODUCT_CONTEXT('',#") + len(b"PRODUCT_CONTEXT('',#")
    contents = in_one_process(data[:start] + b"9" + data[start:])
    assert any("faults in the file" in remark for remark in contents.remarks)
    assert contents.bodies[0].smooth.volume == pytest.approx(1, rel=1e-12)


def test_without_the_extra(tmp_path, monkeypatch):
    data = file_of(tmp_path / "x", BRepPrimAPI_MakeBox(1, 1, 1).Shape())
    for module in [name for name in sys.modules if name.split(".")[0] == "OCP"]:
        monkeypatch.setitem(sys.modules, module, None)
    kernel.kernel.cache_clear()
    with pytest.raises(MachineError, match=r"pip install 'gearwright\[step\]'"):
        in_one_process(data)
    monkeypatch.undo()
    kernel.kernel.cache_clear()
    assert len(in_one_process(data).bodies) == 1


def test_what_crashes_the_kernel_or_keeps_it_is_refused(tmp_path, monkeypatch):
    data = file_of(tmp_path / "x", BRepPrimAPI_MakeBox(1, 1, 1).Shape())
    monkeypatch.setattr(reading, "LEAST_SECONDS", 0.05)
    with pytest.raises(FileError, match=r"part.step: Open CASCADE was not done with this STEP file after 1 s"):
        reading.parse(data, "part.step")
    monkeypatch.undo()
    (tmp_path / "OCP").mkdir()
    (tmp_path / "OCP" / "__init__.py").write_text("import os\nos.abort()\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(FileError, match=r"part.step: Open CASCADE crashed on this STEP file \(exit code -6"):
        reading.parse(data, "part.step")
