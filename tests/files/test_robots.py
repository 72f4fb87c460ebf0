"""Files for simulators are written with their meshes, all or none, and only where they can be loaded."""

from xml.etree import ElementTree as ET

import mujoco
import numpy as np
import pytest

import gearwright as gw
from gearwright.disk import written_together
from gearwright.errors import FileError, GeometryError, MachineError, ParameterError
from gearwright.files.robots import mjcf
from gearwright.files.stl import writer

PAIR = gw.GearPair(kind="spur", teeth=(13, 17), module=2.0, face_width=6.0)
GEAR = PAIR.pinion
COARSE = 0.5
SUFFIXES = [".urdf", ".sdf", ".xml", ".mjcf"]

every_suffix = pytest.mark.parametrize("suffix", SUFFIXES)


def files(folder):
    """All files below a folder and what they hold."""
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


@every_suffix
def test_meshes_lie_beside_the_file_in_metres(tmp_path, suffix):
    PAIR.save(tmp_path / f"pair{suffix}", COARSE, density="steel")
    assert set(files(tmp_path)) == {f"pair{suffix}", "pair_meshes/pinion.stl", "pair_meshes/gear.stl"}
    mesh = gw.Model.load(tmp_path / "pair_meshes/pinion.stl")
    assert mesh.length_unit == "m"
    (body,) = mesh.bodies.values()
    wanted = PAIR.pinion.polyhedron(COARSE).properties()
    assert body.properties().volume == pytest.approx(wanted.volume * 1e-9, rel=1e-5)


@every_suffix
def test_the_files_are_the_same_every_time(tmp_path, suffix):
    PAIR.save(tmp_path / f"pair{suffix}", COARSE, density=7850)
    first = files(tmp_path)
    PAIR.save(tmp_path / f"pair{suffix}", COARSE, density="steel")
    assert files(tmp_path) == first


@pytest.mark.parametrize("name", ["a & b <c>", "größe 'x' \"y\"", "two  blanks", "--x--"])
@every_suffix
def test_any_printable_name_is_written_so_that_it_reads_back(tmp_path, name, suffix):
    GEAR.save(tmp_path / f"{name}{suffix}", COARSE, density="steel")
    root = ET.parse(tmp_path / f"{name}{suffix}").getroot()  # noqa: S314  our own file
    named = root if suffix == ".urdf" else root.find("model") if suffix == ".sdf" else None
    assert (root.get("model") if named is None else named.get("name")) == name
    if suffix != ".sdf":
        assert mujoco.MjModel.from_xml_path(str(tmp_path / f"{name}{suffix}")).body("part").mass[0] > 0.0


@every_suffix
def test_a_name_that_xml_cannot_hold_is_refused(tmp_path, suffix):
    with pytest.raises(FileError, match="letters and digits"):
        GEAR.save(tmp_path / f"a\x07b{suffix}", COARSE, density="steel")
    assert files(tmp_path) == {}


@every_suffix
def test_a_failure_leaves_everything_as_it_was(tmp_path, suffix, monkeypatch):
    path = tmp_path / f"pair{suffix}"
    PAIR.save(path, COARSE, density="steel")
    (tmp_path / "pair_meshes/notes.txt").write_text("mine")
    before = files(tmp_path)
    real, calls = writer.write, []

    def second_fails(target, assembly):
        calls.append(target)
        if len(calls) == 2:
            raise MachineError(f"{target}: the disk is full")
        real(target, assembly)

    monkeypatch.setattr(writer, "write", second_fails)
    with pytest.raises(MachineError) as refused:
        PAIR.save(path, 2.0 * COARSE, density="brass")
    assert str(refused.value) == f"{tmp_path / 'pair_meshes/gear.stl'}: the disk is full"
    assert len(calls) == 2
    assert files(tmp_path) == before
    monkeypatch.setattr(writer, "write", real)
    PAIR.save(path, 2.0 * COARSE, density="brass")
    after = files(tmp_path)
    assert after.keys() == before.keys()
    assert [name for name in before if before[name] == after[name]] == ["pair_meshes/notes.txt"]


def fill(folder, contents):
    for name, text in contents.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text)


OLD = {"a.txt": "1", "m/b.txt": "2", "m/other.txt": "3", "z.txt": "4"}
NEW = {"a.txt": "10", "m/b.txt": "20", "n/c.txt": "30", "z.txt": "40"}


@pytest.mark.parametrize("failing", range(7))
def test_whichever_renaming_fails_all_is_taken_back(tmp_path, monkeypatch, failing):
    """a, b and z are moved away and replaced, c is new: seven renamings."""
    fill(tmp_path, OLD)
    real, calls = type(tmp_path).replace, []

    def replace(self, target):
        calls.append(self)
        if len(calls) == failing + 1:
            raise PermissionError(13, "no")
        return real(self, target)

    monkeypatch.setattr(type(tmp_path), "replace", replace)
    with pytest.raises(MachineError, match="nothing was changed"), written_together(tmp_path) as staged:
        fill(staged, NEW)
    assert {name: text.decode() for name, text in files(tmp_path).items()} == OLD
    assert {path.name for path in tmp_path.iterdir()} == {"a.txt", "m", "z.txt"}


def test_links_to_other_disks_are_followed(tmp_path, monkeypatch):
    fill(tmp_path, OLD)

    def replace(self, target):
        raise OSError(18, "Invalid cross-device link")

    monkeypatch.setattr(type(tmp_path), "replace", replace)
    with written_together(tmp_path) as staged:
        fill(staged, NEW)
    assert {name: text.decode() for name, text in files(tmp_path).items()} == {**OLD, **NEW}


def test_all_is_exchanged_and_nothing_else_stays(tmp_path):
    fill(tmp_path, OLD)
    (tmp_path / "a.txt").chmod(0o640)
    with written_together(tmp_path) as staged:
        fill(staged, NEW)
    assert {name: text.decode() for name, text in files(tmp_path).items()} == {**OLD, **NEW}
    assert {path.name for path in tmp_path.iterdir()} == {"a.txt", "m", "n", "z.txt"}
    assert (tmp_path / "a.txt").stat().st_mode & 0o777 == 0o640


def test_a_link_is_followed(tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "real/a.txt").write_text("1")
    (tmp_path / "a.txt").symlink_to(tmp_path / "real/a.txt")
    with written_together(tmp_path) as staged:
        fill(staged, {"a.txt": "2"})
    assert (tmp_path / "a.txt").is_symlink()
    assert (tmp_path / "real/a.txt").read_text() == "2"


@pytest.mark.parametrize("in_the_way", ["pair.urdf", "pair_meshes/gear.stl"])
def test_a_folder_in_a_files_place_is_refused(tmp_path, in_the_way):
    (tmp_path / in_the_way).mkdir(parents=True)
    with pytest.raises(FileError, match="this is a folder or device"):
        PAIR.save(tmp_path / "pair.urdf", COARSE, density="steel")
    assert files(tmp_path) == {}


def test_a_file_in_the_meshes_place_is_refused(tmp_path):
    (tmp_path / "pair_meshes").write_text("mine")
    with pytest.raises(FileError, match="a file stands in its way"):
        PAIR.save(tmp_path / "pair.urdf", COARSE, density="steel")
    assert files(tmp_path) == {"pair_meshes": b"mine"}


def test_a_folder_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(FileError, match="there is no such folder"):
        PAIR.save(tmp_path / "nowhere/pair.urdf", COARSE, density="steel")


@every_suffix
def test_masses_need_a_density(tmp_path, suffix):
    for one in (PAIR, GEAR, GEAR.solid):
        with pytest.raises(FileError, match=r"holds masses; give a density.*steel.*kg/m³"):
            one.save(tmp_path / f"x{suffix}", COARSE)
        with pytest.raises(ParameterError, match=r"there is no such one.*steel"):
            one.save(tmp_path / f"x{suffix}", COARSE, density="stel")
        for density in (0.0, -1.0, float("nan"), float("inf")):
            with pytest.raises(ParameterError, match="kg/m³"):
                one.save(tmp_path / f"x{suffix}", COARSE, density=density)
    assert files(tmp_path) == {}


@pytest.mark.parametrize("name", ["x.stl", "x"])
def test_shapes_alone_take_no_density(tmp_path, name):
    with pytest.raises(FileError, match=r"density = 'steel' has no place.*\.urdf"):
        PAIR.save(tmp_path / name, COARSE, density="steel")
    assert files(tmp_path) == {}


@every_suffix
def test_polygons_alone_have_no_mass(tmp_path, suffix):
    with pytest.raises(FileError, match="polygons alone are given"):
        GEAR.polyhedron(COARSE).save(tmp_path / f"x{suffix}")
    assert files(tmp_path) == {}


def test_what_mujoco_could_not_load_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(mjcf, "MOST_TRIANGLES", 3000)
    light = gw.SpurGear(teeth=17, module=2.0, face_width=6.0)
    with pytest.raises(FileError) as refused:
        light.save(tmp_path / "x.xml", 0.001, density=1e-9)
    headline, *problems = str(refused.value).splitlines()
    assert headline == f"{tmp_path / 'x.xml'}: MuJoCo could not load it:"
    assert len(problems) == 2
    assert "at most 3000 are taken; use a coarser tolerance" in problems[0]
    assert "check density and length unit" in problems[1]
    assert files(tmp_path) == {}


def test_the_limits_are_mujoco_s(tmp_path):
    """A body just above its least inertia loads, one below does not."""
    assert mujoco.mjMINVAL == mjcf.LEAST_MASS
    tiny = gw.extrude(gw.Section.rectangle(1.0, 1.0), 1.0)
    at_limit = 6.0 * mjcf.LEAST_MOMENT / 1e-3**5  # kg/m³: of a cube, ρ a³ a²/6 is the least moment
    tiny.save(tmp_path / "x.xml", density=at_limit * 1.001)
    inertia = mujoco.MjModel.from_xml_path(str(tmp_path / "x.xml")).body("part").inertia
    assert inertia.min() == pytest.approx(mjcf.LEAST_MOMENT, rel=2e-3)
    with pytest.raises(FileError, match="could not load"):
        tiny.save(tmp_path / "x.xml", density=at_limit * 0.999)
    root = ET.parse(tmp_path / "x.xml").getroot()  # noqa: S314  our own file
    stated = root.find("worldbody/body/inertial")
    lighter = [0.998 * float(word) for word in stated.get("fullinertia").split()]
    stated.set("fullinertia", " ".join(map(repr, lighter)))
    ET.ElementTree(root).write(tmp_path / "x.xml")
    with pytest.raises(ValueError, match="inertia must have positive eigenvalues"):
        mujoco.MjModel.from_xml_path(str(tmp_path / "x.xml"))


def test_impossible_properties_are_refused():
    from gearwright.solids.inertial import inertial_of

    flat = gw.MassProperties(volume=1.0, centroid=np.zeros(3), central_second=np.diag([1.0, 1.0, -1.0]))
    with pytest.raises(GeometryError, match="no body can have these properties"):
        inertial_of("part", flat, "mm")


def test_gears_of_watches_load(tmp_path):
    """A hundredth of a gramme of brass."""
    gear = gw.SpurGear(teeth=12, module=0.1, face_width=0.3)
    gear.save(tmp_path / "gear.xml", density="brass")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "gear.xml"))
    assert model.body("part").mass[0] == gear.properties(gw.density("brass")).mass
