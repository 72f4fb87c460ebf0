"""XML text as a tree, without what makes a small file expand into a large one."""

from __future__ import annotations

from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

from ...errors import FileError

_LONGEST_ENTITY = 256
"""Characters of an abbreviation; those of drawing programs are the addresses of name spaces."""

_DEEPEST = 200
"""Elements within elements; groups of a drawing go some ten deep."""


def parsed(source: str, data: bytes) -> Element:
    """The root element; tags and attributes carry no name space but that of Inkscape, as "inkscape:label".

    Raises FileError where this is no XML, or its abbreviations (entities) are long or hold one another.
    """
    builder, depth = TreeBuilder(), 0
    parser = expat.ParserCreate(namespace_separator="}")

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > _DEEPEST:
            raise FileError(f"{source}: groups nested more than {_DEEPEST} deep; ungroup the drawing")
        builder.start(_local(tag), {_local(name): value for name, value in attributes.items()})

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(_local(tag))

    def entity(name: str, _parameter: bool, value: str | None, *_where: str | None) -> None:
        if value is None or len(value) > _LONGEST_ENTITY or "&" in value or "%" in value:
            raise FileError(
                f"{source}: the XML entity {name!r} stands for another file, other entities or a long text; "
                "save the drawing as plain SVG"
            )

    parser.StartElementHandler, parser.EndElementHandler, parser.EntityDeclHandler = start, end, entity
    try:
        parser.Parse(data, True)
    except (expat.ExpatError, LookupError, ValueError) as error:
        raise FileError(f"{source}: this is no whole SVG file ({error}); save the drawing again as plain SVG") from None
    return builder.close()


def _local(name: str) -> str:
    """A name without its name space; those of Inkscape and of other programs keep a prefix."""
    space, _, local = name.rpartition("}")
    if not space or space.endswith(("/svg", "/xlink")):
        return local
    return f"inkscape:{local}" if "inkscape" in space else f"foreign:{local}"
