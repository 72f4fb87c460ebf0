"""What is said of a pair's running, and its diagram."""

import json

import numpy as np
import pytest
from matplotlib.image import imread

import gearwright as gw
from gearwright.cli import main
from gearwright.contact.diagram import draw
from gearwright.contact.running import lines_over_a_pitch, running
from gearwright.contact.transmission import transmission_error
from gearwright.elements.bevel.bevel_pair import BevelPair

from .test_transmission import BASIC, SPIRAL

WORDS = "--teeth 16 20 --module 4 --face-width 10".split()


def test_an_involute_pair_minds_no_shaft_angle_but_an_offset():
    found = running(BevelPair(**BASIC))
    assert found["transmission_error"].value == 0.0
    assert found["transmission_error_at_shaft_angle_error"].value == 0.0
    assert found["offset_error"].value == 0.04
    apart = transmission_error(BevelPair(**BASIC), offset_error=0.04, samples=48)
    assert found["transmission_error_at_offset_error"].value == pytest.approx(1e6 * np.ptp(apart.lead), rel=1e-12)
    assert 1.0 < found["transmission_error_at_offset_error"].value < 100.0


def test_lines_of_contact_are_one_face_width_a_tooth_where_teeth_are_straight():
    pair = BevelPair(**BASIC, ends="spherical")
    lines = lines_over_a_pitch(pair)
    np.testing.assert_allclose(lines.lengths, 10.0 * lines.counts, rtol=1e-12)
    assert set(lines.counts) == {1.0, 2.0}
    assert lines.counts.mean() == pytest.approx(pair.sizes()["contact_ratio"].value, abs=0.01)


def test_spirals_hand_over_more_smoothly():
    found = {name: running(BevelPair(**BASIC, **more)) for name, more in {"straight": {}, "spiral": SPIRAL}.items()}
    swing = {
        name: one["greatest_contact_length"].value / one["least_contact_length"].value for name, one in found.items()
    }
    assert swing["straight"] == pytest.approx(2.0, rel=0.02)
    assert swing["spiral"] < 1.7


@pytest.mark.parametrize(
    "more", [{}, SPIRAL, {"shaft_angle": 60.0, "length_unit": "in"}], ids=["straight", "spiral", "in"]
)
def test_a_diagram_is_drawn(tmp_path, more):
    draw(BevelPair(**{**BASIC, "face_width": 0.4 if "length_unit" in more else 10.0}, **more), tmp_path / "pair.png")
    pixels = imread(tmp_path / "pair.png")
    assert pixels.shape == (1260, 2040, 4)
    assert 0.01 < (pixels[..., :3].min(axis=-1) < 0.6).mean() < 0.2


def test_lines_are_drawn_where_they_are(tmp_path):
    """The flank is as high at its ends as the tip and form cones say, by the ratio to the face width."""
    pair = BevelPair(**BASIC)
    draw(pair, tmp_path / "pair.png")
    pixels = imread(tmp_path / "pair.png")[:, :1000, :3]
    blue = np.argwhere(np.abs(pixels - np.array([0x1F, 0x5F, 0xA8]) / 255.0).max(axis=-1) < 0.03)
    blue = blue[(blue[:, 0] > 170) & (blue[:, 0] < 862)]
    height, width = np.ptp(blue, axis=0)
    tooth = pair.pinion.tooth
    expected = (tooth.face_angle - tooth.form_angle) * pair.pinion.cone_distance / pair.pinion.face_width
    assert height / width == pytest.approx(expected, rel=0.02)


def test_the_same_pair_gives_the_same_svg(tmp_path):
    for name in ("one.svg", "two.svg"):
        draw(BevelPair(**BASIC), tmp_path / name)
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "two.svg").read_bytes()


def test_other_files_are_refused(tmp_path):
    with pytest.raises(gw.FileError, match="PNG or SVG"):
        draw(BevelPair(**BASIC), tmp_path / "pair.pdf")


def test_the_command_line_tells_and_draws(tmp_path, capsys):
    path = tmp_path / "new" / "pair.png"
    assert main(["bevel", *WORDS, "--running", "--json", "--diagram", str(path)]) == 0
    printed = capsys.readouterr()
    assert f"wrote {path}" in printed.err
    assert path.stat().st_size > 10_000
    found = json.loads(printed.out)["pair"]["running"]
    assert found["transmission_error"] == {"value": 0.0, "unit": "urad", "symbol": "TE"}
    assert found["offset_error"] == {"value": 0.04, "unit": "mm", "symbol": "E"}
    assert main(["bevel", *WORDS, "--running"]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["transmission", "error", "TE", "µrad", "0"] in rows


def test_without_asking_nothing_is_said(capsys):
    assert main(["bevel", *WORDS, "--json"]) == 0
    assert "running" not in json.loads(capsys.readouterr().out)["pair"]


def test_others_are_refused(capsys):
    assert main("spur --teeth 16 --module 8 --face-width 50 --running --diagram a.png".split()) == 2
    printed = capsys.readouterr().err
    assert "--running: applies to a bevel pair" in printed
    assert "--diagram: applies to a bevel pair or a cam" in printed
    assert main("bevel --teeth 16 --mate-teeth 20 --module 4 --face-width 10 --running".split()) == 2
    assert "--running: applies to a bevel pair" in capsys.readouterr().err
