import subprocess
import sys
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest

from gearwright.colours import BRASS
from gearwright.errors import FileError, MachineError
from gearwright.pictures import Body, View, picture

from .shapes import cube, sphere

SMALL = (400, 250)


def block(label="", middle=(0.0, 0.0, 0.0)):
    vertices, triangles = cube(middle=middle)
    return Body(vertices=vertices, triangles=triangles, colour=BRASS, label=label)


def test_a_file_of_the_size_asked_for_is_written(tmp_path):
    path = tmp_path / "block.png"
    picture([block("Block\nside 1 mm")], path, title="A block", size=SMALL)
    pixels = matplotlib.image.imread(path)
    assert pixels.shape[:2] == (250, 400)
    assert [entry.name for entry in tmp_path.iterdir()] == ["block.png"]


def test_writing_stays_inside_the_picture(tmp_path):
    bodies = [block("First\n16 teeth"), block("Second\n20 teeth", middle=(1.4, 0.3, 0.0))]
    path = tmp_path / "named.png"
    picture(
        bodies,
        path,
        title="A title much too long for such a picture " * 3,
        view=View(direction=(0.3, -1.0, 0.5)),
        size=(800, 500),
    )
    pixels = matplotlib.image.imread(path)[..., :3]
    border = np.concatenate([pixels[[0, -1]].reshape(-1, 3), pixels[:, [0, -1]].reshape(-1, 3)])
    assert border.min() > 0.9
    assert pixels[:60, 700:].min() < 0.5  # the title ends at the right margin, smaller


def test_a_callout_takes_a_free_place_and_points_into_its_body():
    from gearwright.pictures.annotations import _place

    mask = np.zeros((300, 500), bool)
    mask[100:200, 100:250] = True
    occupied = mask.copy()
    occupied[:, 250:400] = True  # another body to the right
    occupied[:60] = True  # a title
    (left, top), (x, y) = _place(mask, occupied, 60.0, 30.0, 8.0)
    assert not occupied[int(top) : int(top) + 30, int(left) : int(left) + 60].any()
    assert left + 60.0 < 100.0  # on the side where the leader crosses nothing
    assert mask[int(y), int(x)]


def test_a_leader_is_charged_for_what_it_crosses():
    from gearwright.pictures.annotations import _foreign

    mask = np.zeros((100, 300), bool)
    mask[:, 200:] = True
    occupied = mask.copy()
    occupied[:, 100:140] = True
    assert _foreign(mask, occupied, (50.0, 50.0), (250.0, 50.0)) == pytest.approx(40.0, abs=5.0)
    assert _foreign(mask, occupied, (150.0, 20.0), (250.0, 80.0)) == 0.0


def test_a_callout_without_room_is_left_out():
    from gearwright.pictures.annotations import _place

    mask = np.ones((100, 100), bool)
    assert _place(mask, mask, 40.0, 20.0, 8.0) is None
    assert _place(np.zeros_like(mask), np.zeros_like(mask), 40.0, 20.0, 8.0) is None


def test_an_old_file_stays_when_writing_fails(tmp_path, monkeypatch):
    path = tmp_path / "old.png"
    path.write_bytes(b"old")

    def full(self, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(MachineError, match="No space left"):
        picture([block()], path, size=SMALL)
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["old.png"]


def test_an_old_file_stays_when_drawing_fails(tmp_path, monkeypatch):
    path = tmp_path / "old.png"
    path.write_bytes(b"old")

    def broken(*arguments):
        raise RuntimeError("broken")

    monkeypatch.setattr("gearwright.pictures.image.image", broken)
    with pytest.raises(RuntimeError, match="broken"):
        picture([block()], path, size=SMALL)
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["old.png"]


def test_a_missing_folder_is_named(tmp_path):
    with pytest.raises(FileError, match=r"no folder .*missing"):
        picture([block()], tmp_path / "missing" / "block.png")


@pytest.mark.parametrize("name", ["block.jpg", "block", "block.stl"])
def test_only_png_is_written_and_the_message_says_so(tmp_path, name):
    with pytest.raises(FileError, match=r"\.png"):
        picture([block()], tmp_path / name)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ({"vertices": np.full((8, 3), np.nan)}, "finite"),
        ({"vertices": np.zeros((8, 2))}, "vertices"),
        ({"triangles": np.empty((0, 3), int)}, "at least one"),
        ({"triangles": np.array([[0, 1, 8]])}, "0 to 7"),
        ({"triangles": np.array([[0, 1, -1]])}, "0 to 7"),
        ({"colour": (2.0, 0.0, 0.0)}, "colour"),
    ],
)
def test_impossible_bodies_are_refused_by_name(change, text):
    vertices, triangles = cube()
    with pytest.raises(ValueError, match=f"'Block'.*{text}"):
        Body(**{"vertices": vertices, "triangles": triangles, "label": "Block\nsteel", **change})


def test_nothing_to_draw_and_no_size_are_refused(tmp_path):
    with pytest.raises(ValueError, match="at least one body"):
        picture([], tmp_path / "none.png")
    with pytest.raises(ValueError, match="size"):
        picture([block()], tmp_path / "none.png", size=(10, 10))


def test_a_body_of_degenerate_triangles_only_still_gives_a_picture(tmp_path):
    flat = Body(vertices=np.zeros((3, 3)), triangles=np.array([[0, 1, 2]]), label="point")
    ball, triangles = sphere(rings=8)
    picture([flat, Body(vertices=ball, triangles=triangles)], tmp_path / "ball.png", size=SMALL)
    picture([flat], tmp_path / "flat.png", size=SMALL)


def test_numba_and_matplotlib_load_only_when_something_is_drawn():
    code = "import sys, gearwright.pictures; assert not {'numba', 'matplotlib', 'scipy'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)
