"""The page of a view: whole, loading nothing, and safe whatever a title says; a still picture without the viewer."""

import json
import re
from html.parser import HTMLParser

import numpy as np
import pytest

import gearwright as gw
from gearwright.viewer import document

PAIR = gw.GearPair(teeth=(17, 30), module=2, face_width=10)
TETRAHEDRON = gw.Polyhedron([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


class Elements(HTMLParser):
    """Names of the elements with their attributes, and the text inside each script."""

    def __init__(self, text):
        super().__init__()
        self.found, self.scripts = [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.found.append((tag, dict(attributes)))

    def handle_data(self, data):
        if self.cdata_elem == "script":
            self.scripts.append(data)


@pytest.fixture
def viewer(tmp_path, monkeypatch):
    """A script in the viewer's place that holds what could end the element it stands in."""
    script = tmp_path / "viewer.js"
    script.write_text('const text = "</script><!--";')
    monkeypatch.setattr(document, "SCRIPT", script)


@pytest.fixture
def no_viewer(tmp_path, monkeypatch):
    monkeypatch.setattr(document, "SCRIPT", tmp_path / "none.js")


def scene(view):
    return json.loads(Elements(view.page).scripts[0])


def test_a_pair_runs_in_its_colours_under_its_names(viewer):
    found = scene(PAIR.show())
    assert [body["name"] for body in found["bodies"]] == ["pinion", "gear"]
    assert found["turns"] == 180.0
    assert found["unit"] == "mm"
    assert found["bodies"][1]["spin"] == pytest.approx(-17 / 30)
    np.testing.assert_allclose(found["bodies"][1]["place"], PAIR.placements()[1].reshape(-1))
    assert found["bodies"][0]["colour"] != found["bodies"][1]["colour"]
    assert found["bodies"][1]["most"][0] == PAIR.parts()[1].placed.vertices[:, 0].max()


def test_one_part_does_not_run(viewer):
    assert scene(PAIR.gear.show())["turns"] is None
    assert scene(TETRAHEDRON.show())["bodies"][0]["closed"]


def test_nothing_in_a_title_or_the_script_ends_its_element(viewer):
    view = TETRAHEDRON.show(title='</script><img src="//evil"> & "quoted"')
    tags = Elements(view.page)
    assert [tag for tag, _ in tags.found if tag in ("script", "img", "iframe")] == ["script", "script"]
    assert len(tags.scripts) == 2
    assert re.fullmatch(r'const text = ".*script>.*";', tags.scripts[1])  # whole
    assert json.loads(tags.scripts[0])["title"] == view.title
    frame = Elements(view._repr_html_())
    assert [tag for tag, _ in frame.found] == ["iframe"]
    assert frame.found[0][1]["srcdoc"] == view.page
    assert frame.found[0][1]["title"] == view.title
    assert frame.found[0][1]["sandbox"] == "allow-scripts"


def test_the_page_forbids_to_load_anything(viewer):
    ((_, policy),) = [one for one in Elements(PAIR.show().page).found if "http-equiv" in one[1]]
    assert policy["http-equiv"] == "Content-Security-Policy"
    assert policy["content"].startswith("default-src 'none';")
    assert "connect-src" not in policy["content"]


def test_the_view_is_saved_as_a_page(viewer, tmp_path):
    view = TETRAHEDRON.show()
    view.save(tmp_path / "view.html")
    assert (tmp_path / "view.html").read_text(encoding="utf-8") == view.page
    with pytest.raises(gw.FileError, match=r"end the name in \.html"):
        view.save(tmp_path / "view.png")


def test_without_the_viewer_there_is_a_still_picture_and_how_to_get_the_other(no_viewer, tmp_path):
    view = PAIR.show()
    shown = view._repr_html_()
    assert "make web" in shown
    assert re.search(r'<img src="data:image/png;base64,[^"]{20000,}" alt="Gear pair: 17/30 teeth[^"]*"', shown)
    view.save(tmp_path / "view.html")
    assert "<script" not in (tmp_path / "view.html").read_text(encoding="utf-8")
