"""Diagrams: written whole, the same each time, refused with the reason."""

import numpy as np
import pytest
from matplotlib.image import imread

import gearwright as gw

from ...examples import EXAMPLES

CAM = EXAMPLES["cam"]["oscillating roller"]


@pytest.mark.parametrize("example", EXAMPLES["cam"])
def test_every_cam_has_a_diagram(tmp_path, example):
    gw.Cam(**EXAMPLES["cam"][example]).diagram(tmp_path / "cam.png")
    pixels = imread(tmp_path / "cam.png")
    assert pixels.shape == (1260, 2040, 4)
    ink = (pixels[..., :3].min(axis=-1) < 0.6).mean()
    assert 0.01 < ink < 0.2


def test_the_profile_is_drawn_where_the_axes_say(tmp_path):
    """The disk's blue outline is as wide as it is high by the ratio of its extents: equal scales."""
    cam = gw.Cam(**CAM)
    cam.diagram(tmp_path / "cam.png")
    pixels = imread(tmp_path / "cam.png")[:, :1040, :3]
    blue = np.argwhere(np.abs(pixels - np.array([0x1F, 0x5F, 0xA8]) / 255.0).max(axis=-1) < 0.02)
    blue = blue[(blue[:, 0] > 160) & (blue[:, 0] < 990)]
    height, width = np.ptp(blue, axis=0)
    points = cam.traced.points(np.linspace(0.0, 2.0 * np.pi, 2000))
    assert height / width == pytest.approx(np.ptp(points[:, 1]) / np.ptp(points[:, 0]), rel=0.01)


def test_the_same_cam_gives_the_same_svg(tmp_path):
    for name in ("one.svg", "two.svg"):
        gw.Cam(**CAM).diagram(tmp_path / name)
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "two.svg").read_bytes()


def test_other_files_are_refused(tmp_path):
    with pytest.raises(gw.FileError, match=r"PNG or SVG"):
        gw.Cam(**CAM).diagram(tmp_path / "cam.pdf")
    with pytest.raises(gw.FileError, match=r"there is no folder"):
        gw.Cam(**CAM).diagram(tmp_path / "missing" / "cam.png")
