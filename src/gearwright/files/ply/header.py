"""The header of a PLY file: its form, and the elements that follow, in their order."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from ...errors import FileError
from ..text.places import AGAIN, MARK, line_at, shown, with_line_feeds

Form = Literal["ascii", "binary_little_endian", "binary_big_endian"]

TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "float": "f4", "double": "f8",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
    "float32": "f4", "float64": "f8",
}  # fmt: skip
"""Names of types, old and new, and their kind and bytes."""

LISTS = ("vertex_indices", "vertex_index")
"""Names of the list of a face's vertices."""

LONGEST = 1 << 16
_LONGEST_NAME = 64
_MOST = 10**18
"""More than any file holds: larger counts are refused as no numbers."""


@dataclass(frozen=True, kw_only=True)
class Property:
    """A property: type as in TYPES' values, and that of a list's count."""

    name: str
    type: str
    count_type: str | None = None


@dataclass(frozen=True, kw_only=True)
class Element:
    """So many rows of properties."""

    name: str
    count: int
    properties: tuple[Property, ...]

    @property
    def listed(self) -> str:
        """The names of the properties, of many the first."""
        names = [one.name for one in self.properties]
        return ", ".join(names[:8]) + (f" and {len(names) - 8} more" if len(names) > 8 else "")

    def named(self, *names: str) -> Property | None:
        """The first property of one of these names."""
        return next((one for one in self.properties if one.name in names), None)


@dataclass(frozen=True, kw_only=True)
class Header:
    """The header, and the byte at which the data begin."""

    form: Form
    elements: tuple[Element, ...]
    end: int

    def element(self, name: str) -> Element | None:
        """The element of a name."""
        return next((one for one in self.elements if one.name == name), None)


def read_header(data: bytes, path: str) -> Header:
    """The header. Raises FileError with the line that does not fit."""
    start = len(MARK) if data.startswith(MARK) else 0
    lines, end = _lines(data, start, path)
    if [word.lower() for word in lines[0][1]] != ["ply"]:
        raise FileError(f'{path}: this is no PLY file: its first line is not "ply"')
    form: Form | None = None
    elements: list[Element] = []
    for place, words in lines[1:]:
        match words:
            case [] | ["comment" | "obj_info", *_]:
                pass
            case ["format", str(named), "1.0"] if named in get_args(Form) and form is None:
                form = named  # type: ignore[assignment]
            case [_, *rest] if any(len(word) > _LONGEST_NAME for word in rest):
                raise _refusal(path, data, place, words)
            case ["element", str(name), count] if count.isascii() and count.isdigit() and int(count[:19]) < _MOST:
                if any(name == one.name for one in elements):
                    raise _refusal(path, data, place, words)
                elements.append(Element(name=name, count=int(count), properties=()))
            case ["property", *words_of] if elements and (found := _property(words_of)):
                last = elements[-1]
                if last.named(found.name):
                    raise _refusal(path, data, place, words)
                elements[-1] = Element(name=last.name, count=last.count, properties=(*last.properties, found))
            case _:
                raise _refusal(path, data, place, words)
    if form is None:
        raise FileError(f'{path}: this PLY file has no line "format ascii 1.0" or one of a binary form; {AGAIN}')
    for element in elements:
        if not element.properties:
            raise FileError(f"{path}: the element {element.name} of this PLY file has no properties; {AGAIN}")
    return Header(form=form, elements=tuple(elements), end=end)


def _lines(data: bytes, start: int, path: str) -> tuple[list[tuple[int, list[str]]], int]:
    """Places and words of the lines before "end_header", and where the line after that begins."""
    feed = b"\n" if b"\n" in data[: start + LONGEST] else b"\r"
    lines: list[tuple[int, list[str]]] = []
    place = start
    while place < min(len(data), start + LONGEST):
        end = data.find(feed, place, start + LONGEST)
        end = len(data) if end < 0 else end
        words = data[place : min(end, start + LONGEST)].decode("ascii", "replace").split()
        if words == ["end_header"]:
            return lines or [(place, [])], end + 1
        lines.append((place, words))
        if len(lines) == 1 and [word.lower() for word in words] != ["ply"]:
            break
        place = end + 1
    if not lines or [word.lower() for word in lines[0][1]] != ["ply"]:
        raise FileError(f'{path}: this is no PLY file: its first line is not "ply"')
    raise FileError(
        f'{path}: the header of this PLY file does not end: "end_header" was expected within {LONGEST} bytes; the file'
        f" is cut off; {AGAIN}"
    )


def _property(words: list[str]) -> Property | None:
    match words:
        case ["list", count_type, item_type, name] if count_type in TYPES and item_type in TYPES:
            return Property(name=name, type=TYPES[item_type], count_type=TYPES[count_type])
        case [item_type, name] if item_type in TYPES:
            return Property(name=name, type=TYPES[item_type])
    return None


def _refusal(path: str, data: bytes, place: int, words: list[str]) -> FileError:
    return FileError(
        f"{path}: line {line_at(with_line_feeds(data), place)} of this PLY file has"
        f' "{shown(" ".join(words), 60)}" where a line of the header is expected: format'
        f" ascii|binary_little_endian|binary_big_endian 1.0, element NAME COUNT, property TYPE NAME, property list TYPE"
        f" TYPE NAME with types {', '.join(list(TYPES)[:8])}, or end_header, every name once; {AGAIN}"
    )
