"""SVG drawings: shapes, transforms and units against closed forms; y points up."""

import sys

import numpy as np
import pytest

import gearwright as gw
from gearwright.curves.arc import Arc
from gearwright.curves.elliptic_arc import EllipticArc
from gearwright.sections import drawings

from .drawn import polygon_moments, section_moments, svg


def load(folder, body, page="", **options):
    return gw.Section.load(svg(folder, body, page), **options)


def centroid(section):
    return section.moments[[1, 0], [0, 1]] / section.moments[0, 0]


@pytest.mark.parametrize(
    ("shape", "area", "middle"),
    [
        ('<circle cx="3" cy="4" r="2"/>', 4 * np.pi, (3, -4)),
        ('<ellipse cx="3" cy="4" rx="2" ry="0.5"/>', np.pi, (3, -4)),
        ('<rect x="1" y="2" width="6" height="4"/>', 24, (4, -4)),
        ('<rect x="1" y="2" width="6" height="4" rx="1"/>', 24 - (4 - np.pi), (4, -4)),
        ('<rect x="1" y="2" width="6" height="4" rx="2" ry="1"/>', 24 - 2 * (4 - np.pi), (4, -4)),
        ('<rect x="1" y="2" width="6" height="4" ry="9"/>', 24 - 6 * (4 - np.pi), (4, -4)),
        ('<polygon points="0,0 6,0 0,3"/>', 9, (2, -1)),
        ('<polyline points="0 0 6 0 0 3 0 0"/>', 9, (2, -1)),
        ('<path d="m1 2h6v4h-6z"/>', 24, (4, -4)),
        ('<path d="M 0 0 A 5 5 0 0 1 10 0 Z"/>', 12.5 * np.pi, (5, 20 / (3 * np.pi))),
        ('<path d="M 0 0 A 1 1 0 0 0 10 0 Z"/>', 12.5 * np.pi, (5, -20 / (3 * np.pi))),
        ('<path d="M4 0a4 2 0 11-8 0 4 2 0 118 0z"/>', 8 * np.pi, (0, 0)),
        ('<path d="M0 0Q2 4 4 0z"/>', 16 / 3, (2, -4 / 5)),
        ('<path d="M0 0q1 2 2 2t2-2z"/>', 16 / 3, (2, -4 / 5)),
    ],
)
def test_shapes_have_their_closed_forms_and_y_points_up(tmp_path, shape, area, middle):
    section = load(tmp_path, shape)
    assert section.moments[0, 0] == pytest.approx(area, rel=1e-13)
    np.testing.assert_allclose(centroid(section), middle, atol=1e-12)


def test_cubic_paths_are_what_svgpathtools_draws(tmp_path):
    import svgpathtools

    d = "M 0,0 C 5,-3 9,1 6,4 S 1,12 -2,6 Z"
    points = [segment.point(t) for segment in svgpathtools.parse_path(d) for t in np.arange(4000) / 4000]
    expected = polygon_moments([(z.real, -z.imag) for z in points])
    section = load(tmp_path, f'<path d="{d}"/>')
    np.testing.assert_allclose(section_moments(section), expected * np.sign(expected[0]), rtol=1e-6)


def test_subpaths_and_shapes_within_one_another_are_holes(tmp_path):
    body = '<path d="M0 0H10V10H0z M2 2v6h2v-6z"/><circle cx="7" cy="5" r="1"/>'
    section = load(tmp_path, body)
    assert [len(loop.curves) for loop in section.loops] == [4, 4, 1]
    assert section.moments[0, 0] == pytest.approx(100 - 12 - np.pi, rel=1e-14)


class TestTransforms:
    def test_they_apply_from_the_inside_out(self, tmp_path):
        body = '<g transform="translate(10, 0)"><g transform="rotate(90)"><circle cx="5" r="1"/></g></g>'
        np.testing.assert_allclose(centroid(load(tmp_path, body)), [10, -5], atol=1e-13)

    def test_a_list_of_them_applies_from_right_to_left(self, tmp_path):
        body = '<circle cx="1" cy="1" r="1" transform="scale(2) translate(3 0),rotate(90 1 0)"/>'
        np.testing.assert_allclose(centroid(load(tmp_path, body)), [6, 0], atol=1e-13)

    def test_turns_and_mirrors_keep_arcs_and_stretches_make_ellipses(self, tmp_path):
        half = '<path transform="{}" d="M 0 0 A 5 5 0 0 1 10 0 Z"/>'
        for transform, kind, factor in [
            ("rotate(33) scale(-2, 2)", Arc, 4),
            ("scale(2, 0.5)", EllipticArc, 1),
            ("skewX(30)", EllipticArc, 1),
            ("matrix(1 2 3 4 5 6)", EllipticArc, 2),
            ("matrix(1 0 0.6 0.8 0 0)", EllipticArc, 0.8),  # half diameters of one length, not square
        ]:
            section = load(tmp_path, half.format(transform))
            assert section.moments[0, 0] == pytest.approx(factor * 12.5 * np.pi, rel=1e-13)
            assert kind in {type(c) for c in section.loops[0].curves}

    def test_a_mirrored_arc_stays_on_its_side(self, tmp_path):
        plain = load(tmp_path, '<path d="M 0 0 A 5 3 20 0 1 7 1 Z"/>')
        mirrored = load(tmp_path, '<path transform="scale(-1 1)" d="M 0 0 A 5 3 20 0 1 7 1 Z"/>')
        np.testing.assert_allclose(centroid(mirrored), centroid(plain) * [-1, 1], rtol=1e-12)

    def test_one_that_cannot_be_read_is_refused_by_name(self, tmp_path):
        with pytest.raises(gw.FileError, match=r"<circle id='pin'> has a transform that cannot be read"):
            load(tmp_path, '<circle id="pin" r="1" transform="turn(3)"/>')

    def test_one_in_a_style_is_refused(self, tmp_path):
        with pytest.raises(gw.FileError, match="transform in its style"):
            load(tmp_path, '<circle r="1" style="fill:none; transform: scale(2)"/>')


class TestUnits:
    @pytest.mark.parametrize(
        ("page", "unit", "factor"),
        [
            ('width="210mm" height="297mm" viewBox="0 0 210 297"', "mm", 1),
            ('width="21cm" viewBox="0 0 210 297"', "cm", 0.1),
            ('width="10in" height="254mm" viewBox="0 0 960 960"', "in", 1 / 96),
            ('width="100mm" height="100mm" viewBox="0 0 100 200"', "mm", 0.5),  # fits by its height
            ('width="25.4mm"', "mm", 25.4 / 96),
            ('width="6pc" height="1in" viewBox="0 0 6 6"', "pc", 1),
            ('width="6pc" height="0.5in" viewBox="0 0 6 6"', "pc", 0.5),
            ('width="72pt" height="6pc" viewBox="0 0 72 72"', "pt", 1),
            ('width="500" height="300" viewBox="0 0 50 30"', None, 1),
            ('viewBox="0 0 50 30"', None, 1),
            ('width="100%" viewBox="0 0 50 30"', None, 1),
            ("", None, 1),
        ],
    )
    def test_the_width_of_the_page_states_the_unit(self, tmp_path, page, unit, factor):
        path = svg(tmp_path, '<circle cx="10" cy="20" r="3"/>', page)
        assert drawings.read(path).length_unit == unit
        section = gw.Section.load(path)
        assert section.moments[0, 0] == pytest.approx(9 * np.pi * factor**2, rel=1e-13)
        np.testing.assert_allclose(centroid(section), np.array([10, -20]) * factor, rtol=1e-13)

    def test_a_page_stretched_on_purpose_stretches(self, tmp_path):
        page = 'width="100mm" height="100mm" viewBox="0 0 100 200" preserveAspectRatio="none"'
        section = load(tmp_path, '<rect width="10" height="10"/>', page)
        np.testing.assert_allclose(centroid(section), [5, -2.5])

    def test_lengths_of_shapes_have_units_too(self, tmp_path):
        section = load(tmp_path, '<rect width="1in" height="2.54cm"/>')
        assert section.moments[0, 0] == pytest.approx(96**2, rel=1e-13)

    @pytest.mark.parametrize(
        "page", ['width="-3mm"', 'width="mm"', 'width="3mm" viewBox="0 0 0 1"', 'width="3mm" viewBox="a b c d"']
    )
    def test_a_page_that_is_none_is_refused(self, tmp_path, page):
        with pytest.raises(gw.FileError, match=r"must be above 0|no length|viewBox="):
            load(tmp_path, '<rect width="1" height="1"/>', page)


class TestWhatShows:
    def test_definitions_hidden_things_and_texts_are_no_outlines(self, tmp_path):
        body = (
            '<defs><circle r="9"/></defs><symbol><circle r="9"/></symbol>'
            '<clipPath><rect width="1" height="1"/></clipPath>'
            '<g style="display:none"><circle r="8"/></g><g visibility="hidden"><circle r="7"/>'
            '<circle r="2" visibility="visible"/></g><text>7</text><rect width="0" height="3"/>'
        )
        drawing = drawings.read(svg(tmp_path, body))
        assert drawing.passed_over == {"hidden element": 2, "text": 1}
        assert load(tmp_path, body).moments[0, 0] == pytest.approx(4 * np.pi, rel=1e-14)

    def test_copies_show_what_they_refer_to_where_they_stand(self, tmp_path):
        body = (
            '<defs><g id="hole"><circle r="1"/></g></defs><rect width="20" height="10"/>'
            '<use href="#hole" x="5" y="5"/><use xlink:href="#hole" transform="translate(15 0)" y="5"/>'
        )
        section = load(tmp_path, body)
        assert section.moments[0, 0] == pytest.approx(200 - 2 * np.pi, rel=1e-14)
        assert section.moments[1, 0] == pytest.approx(2000 - 20 * np.pi, rel=1e-13)

    def test_a_copy_of_itself_is_refused(self, tmp_path):
        with pytest.raises(gw.FileError, match="shows itself"):
            load(tmp_path, '<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>')

    def test_a_copy_of_nothing_is_refused(self, tmp_path):
        with pytest.raises(gw.FileError, match=r"refers to '#nut', which is not in this file"):
            load(tmp_path, '<use href="#nut"/>')

    def test_a_page_within_the_page_is_refused(self, tmp_path):
        with pytest.raises(gw.FileError, match=r"<svg id='inset'> is a page within the page"):
            load(tmp_path, '<svg id="inset"><circle r="1"/></svg>')

    def test_layers_of_inkscape_are_read_by_their_labels(self, tmp_path):
        page = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
        layer = '<g inkscape:groupmode="layer" inkscape:label="{}">{}</g>'
        inner = layer.format("Inner", '<circle r="2"/>')
        body = layer.format("Cut", '<circle r="3"/>' + inner) + layer.format("Notes", '<path d="M0 0h99"/>')
        assert len(load(tmp_path, body, page, layer="cut").loops) == 2
        assert load(tmp_path, body, page, layer="Inner").moments[0, 0] == pytest.approx(4 * np.pi, rel=1e-14)
        with pytest.raises(gw.FileError, match="'Cut', 'Inner', 'Notes'"):
            load(tmp_path, body, page, layer="Drill")


class TestRefusals:
    @pytest.mark.parametrize("d", ["M 0 0 L 1", "M 0 0 C 1 1 2 2 z", "M 0 0 L 1 x", "M0 0 l 3 a 4"])
    def test_a_broken_path_is_refused_by_name(self, tmp_path, d):
        with pytest.raises(gw.FileError, match=r"<path id='p7'> has a path that cannot be read"):
            load(tmp_path, f'<path id="p7" d="{d}"/>')

    def test_coordinates_out_of_range(self, tmp_path):
        with pytest.raises(gw.FileError, match="no numbers or beyond 1e"):
            load(tmp_path, '<path d="M 0 0 L 1e999 3 L 4 4 Z"/>')

    @pytest.mark.parametrize("points", ["0,0 1,1 2", "0,0 1,a 2,2"])
    def test_points_that_are_no_pairs(self, tmp_path, points):
        with pytest.raises(gw.FileError, match="not pairs of numbers"):
            load(tmp_path, f'<polygon points="{points}"/>')

    def test_a_negative_radius(self, tmp_path):
        with pytest.raises(gw.FileError, match="r=-1; it cannot be below 0"):
            load(tmp_path, '<circle r="-1"/>')

    def test_a_length_relative_to_something(self, tmp_path):
        with pytest.raises(gw.FileError, match="width='50%'"):
            load(tmp_path, '<rect width="50%" height="2"/>')

    @pytest.mark.parametrize(
        ("text", "match"),
        [
            ("<svg><circle", "no whole SVG"),
            ("<html/>", "its root is <html>"),
            ("\0\1\2", "no whole SVG"),
            ("<svg>" + "<g>" * 5000 + "</g>" * 5000 + "</svg>", "nested more than"),
        ],
    )
    def test_what_is_no_svg(self, tmp_path, text, match):
        path = tmp_path / "drawing.svg"
        path.write_text(text)
        with pytest.raises(gw.FileError, match=match):
            gw.Section.load(path)

    @pytest.mark.parametrize(
        "entities",
        [
            '<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">',
            '<!ENTITY a SYSTEM "file:///etc/hostname">',
            f'<!ENTITY a "{"x" * 1000}">',
        ],
    )
    def test_entities_that_grow_or_read_files(self, tmp_path, entities):
        path = tmp_path / "drawing.svg"
        path.write_text(f'<!DOCTYPE svg [{entities}]><svg xmlns="http://www.w3.org/2000/svg">&a;</svg>')
        with pytest.raises(gw.FileError, match=r"XML entity '[ab]' stands for"):
            gw.Section.load(path)

    def test_an_entity_for_a_name_space_is_harmless(self, tmp_path):
        path = tmp_path / "drawing.svg"
        path.write_text(
            '<!DOCTYPE svg [<!ENTITY s "http://www.w3.org/2000/svg">]><svg xmlns="&s;"><circle r="1"/></svg>'
        )
        assert gw.Section.load(path).moments[0, 0] == pytest.approx(np.pi, rel=1e-14)

    def test_copies_of_copies_beyond_all_bounds(self, tmp_path, monkeypatch):
        from gearwright.sections.drawings import sheet

        monkeypatch.setattr(sheet, "MOST_CURVES", 500)
        body = '<defs><g id="a0"/>'
        for k in range(1, 8):
            body += f'<g id="a{k}">' + f'<use href="#a{k - 1}"/>' * 10 + "</g>"
        with pytest.raises(gw.FileError, match="more than 500"):
            load(tmp_path, body + '</defs><use href="#a7"/>')

    def test_a_missing_reader_is_the_machines_fault(self, tmp_path, monkeypatch):
        monkeypatch.setitem(sys.modules, "svgpathtools", None)
        with pytest.raises(gw.MachineError, match=r"pip install 'gearwright\[drawing\]'"):
            load(tmp_path, '<circle r="1"/>')
