import subprocess
import sys

import matplotlib.image
import numpy as np
import pytest

from gearwright import FileError
from gearwright.pictures.convergence import Panel, Series, convergence_plot


def panel(**changed):
    steps = np.array([4.0, 8.0, 16.0])
    series = Series(label="volume", quantity=0, style=0, steps=steps, errors=1.0 / steps**2, order=2.0)
    return Panel(**{"title": "layers alone", "label": "layers", "descending": False, "series": (series,), **changed})


def test_a_png_of_one_size_a_panel(tmp_path):
    for count in (1, 3):
        convergence_plot(count * [panel()], tmp_path / "a.png", "A title")
        pixels = matplotlib.image.imread(tmp_path / "a.png")
        assert pixels.shape[1] == count * 600
        assert np.ptp(pixels[..., :3]) > 0.5


def test_an_svg_is_the_same_every_time(tmp_path):
    for name in "ab":
        convergence_plot([panel(), panel(descending=True)], tmp_path / f"{name}.svg")
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()
    assert b"<svg" in (tmp_path / "a.svg").read_bytes()


def test_finer_steps_are_to_the_right(tmp_path):
    """The curve falls from upper left to lower right, for tolerances that shrink and numbers that grow."""
    blue = np.array([0x1F, 0x5F, 0xA8]) / 255.0
    for descending, steps in ((False, [4.0, 8.0, 16.0]), (True, [0.4, 0.2, 0.1])):
        errors = np.array([1e-1, 1e-2, 1e-3])
        series = Series(label="v", quantity=0, style=0, steps=np.array(steps), errors=errors, order=None)
        convergence_plot([panel(descending=descending, series=(series,))], tmp_path / "a.png")
        pixels = matplotlib.image.imread(tmp_path / "a.png")[..., :3]
        rows, columns = np.nonzero(np.abs(pixels - blue).max(axis=-1) < 0.05)
        curve = rows < 0.7 * len(pixels)  # above the legend
        assert np.corrcoef(rows[curve], columns[curve])[0, 1] > 0.95


def test_where_all_is_exact_it_says_so(tmp_path):
    convergence_plot([panel(series=())], tmp_path / "a.png")
    assert (tmp_path / "a.png").stat().st_size > 3000


@pytest.mark.parametrize(("name", "text"), [("a.pdf", ".png or .svg"), ("none/a.png", "there is no folder")])
def test_unusable_names_are_refused(tmp_path, name, text):
    with pytest.raises(FileError, match=text):
        convergence_plot([panel()], tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_nothing_to_draw_is_refused(tmp_path):
    with pytest.raises(ValueError, match="at least one"):
        convergence_plot([], tmp_path / "a.png")


def test_matplotlib_loads_only_when_something_is_drawn():
    code = "import sys, gearwright as gw; gw.approximation_error; assert 'matplotlib' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
