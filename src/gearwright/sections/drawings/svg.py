"""SVG files: paths and basic shapes as they are shown, y pointing up."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import FileError, MachineError
from .sheet import Sheet, Tally
from .svg_shapes import SHAPES, curves_of
from .svg_units import Unusable, length, user_units
from .xml_tree import parsed

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_CONTAINERS = frozenset({"g", "a", "switch"})
_SEEN = frozenset({"text", "image", "foreignObject", "flowRoot"})
"""What shows on the screen and is no outline; definitions, metadata and the like do not show."""

_DEEPEST = 32
"""Copies of copies; more is one that shows itself."""

_PAGE_KINDS = frozenset({"svg", "symbol"})


@dataclass(frozen=True)
class _State:
    """What an element inherits: its matrix (2, 3), layers, whether it shows, and uses it stands within."""

    matrix: Array
    layers: tuple[str, ...] = ()
    visible: bool = True
    uses: tuple[str, ...] = ()


def read(source: str, data: bytes, layer: str | None) -> Sheet:
    """The outlines that show, in the unit of the page's width where it states one, else in user units.

    The origin is the user coordinates'; y points up, so that the section looks as on the screen.
    Raises FileError where the file is no SVG or uses what is not read; MachineError without svgpathtools.
    """
    try:
        import svgpathtools  # noqa: F401
    except ImportError:
        raise MachineError(
            f"{source}: SVG is read by svgpathtools, which is missing: pip install 'gearwright[drawing]'"
        ) from None
    root = parsed(source, data)
    if root.tag != "svg":
        raise FileError(f"{source}: this is no SVG file: its root is <{root.tag.removeprefix('foreign:')}>, not <svg>")
    tally = Tally(source=source, layer=layer)
    targets = {element.get("id", ""): element for element in root.iter()}
    try:
        scale, unit = user_units(root)
        state = _State(matrix=np.array([[scale[0], 0.0, 0.0], [0.0, -scale[1], 0.0]]))
        for child in root:
            _walk(tally, targets, child, state)
    except Unusable as error:
        raise FileError(f"{source}: {error}") from None
    return tally.sheet(unit)


def _walk(tally: Tally, targets: Mapping[str, Element], element: Element, inherited: _State) -> None:
    """Adds what an element shows. Raises Unusable naming an element that cannot be read."""
    tally.step()
    style = _style(element)
    if style.get("display", element.get("display")) == "none":
        tally.passed_over["hidden element"] += 1
        return
    state = _own(element, inherited, style)
    if element.tag in _CONTAINERS:
        for child in element:
            _walk(tally, targets, child, state)
    elif element.tag == "use":
        _follow(tally, targets, element, state)
    elif element.tag == "svg":
        raise Unusable(f"{_named(element)} is a page within the page; ungroup it")
    elif element.tag in _SEEN:
        tally.passed_over[element.tag] += 1
    elif element.tag in SHAPES:
        _shape(tally, element, state)


def _shape(tally: Tally, element: Element, state: _State) -> None:
    wanted = [tally.wants(name) for name in state.layers]
    if not state.visible:
        tally.passed_over["hidden element"] += 1
    elif tally.layer is None or any(wanted):
        try:
            tally.add(curves_of(element, state.matrix))
        except Unusable as error:
            raise Unusable(f"{_named(element)} {error}") from None
    else:
        tally.passed_over[f"{element.tag} on another layer"] += 1


def _follow(tally: Tally, targets: Mapping[str, Element], use: Element, state: _State) -> None:
    """What a <use> shows: a copy of another element, moved by x and y."""
    name = use.get("href", "").removeprefix("#")
    target = targets.get(name)
    if target is None or not name:
        raise Unusable(f"{_named(use)} refers to {use.get('href')!r}, which is not in this file")
    if name in state.uses or len(state.uses) >= _DEEPEST:
        raise Unusable(f"{_named(use)} shows itself; replace it by a plain copy")
    if target.tag in _PAGE_KINDS and (target.tag == "svg" or target.get("viewBox")):
        raise Unusable(
            f"{_named(use)} shows a page with a scale of its own; replace it by a plain copy (unlink the clone)"
        )
    shift = np.array([length(use, "x"), length(use, "y")])
    matrix = np.column_stack([state.matrix[:, :2], state.matrix[:, :2] @ shift + state.matrix[:, 2]])
    state = replace(state, matrix=matrix, uses=(*state.uses, name))
    if target.tag != "symbol":
        _walk(tally, targets, target, state)
        return
    for child in target:
        _walk(tally, targets, child, _own(target, state, _style(target)))


def _own(element: Element, inherited: _State, style: Mapping[str, str]) -> _State:
    """The state of an element within what it inherits."""
    from svgpathtools.parser import parse_transform

    if "transform" in style:
        raise Unusable(f"{_named(element)} has a transform in its style, which is not read; apply it to the shapes")
    matrix = inherited.matrix
    if element.get("transform"):
        try:
            own = np.asarray(parse_transform(element.get("transform"), strict=True))
        except ValueError as error:
            raise Unusable(f"{_named(element)} has a transform that cannot be read ({error})") from None
        matrix = inherited.matrix @ own
    label = element.get("inkscape:label") or element.get("id", "")
    layer = (label,) if element.get("inkscape:groupmode") == "layer" and label else ()
    visibility = style.get("visibility", element.get("visibility"))
    visible = inherited.visible if visibility is None else visibility == "visible"
    return replace(inherited, matrix=matrix, layers=inherited.layers + layer, visible=visible)


def _style(element: Element) -> dict[str, str]:
    """The properties of the style attribute."""
    parts = (part.partition(":") for part in element.get("style", "").split(";"))
    return {name.strip(): value.strip() for name, _, value in parts if value}


def _named(element: Element) -> str:
    name = element.get("id")
    return f"<{element.tag} id={name!r}>" if name else f"<{element.tag}>"
