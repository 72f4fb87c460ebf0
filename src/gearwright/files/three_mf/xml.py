"""XML parts read piece by piece, without document types and so without entities."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import NoReturn, final
from xml.parsers import expat

from ...errors import FileError
from ..text.places import shown

Attributes = Mapping[str, str]

_LONGEST = 1 << 20
"""Bytes of one tag, comment or the like, which are looked through again with every piece that comes: beyond this it
would take time that grows with the square of its length."""


@final
class Reader:
    """Calls `start(tag, attributes)` and `end(tag)` for every element; names are "namespace|name".

    `prefixes` are namespaces by the prefixes that stand for them.
    """

    def __init__(self, source: str, start: Callable[[str, dict[str, str]], None], end: Callable[[str], None]):
        """`source` names the file and the part, for messages."""
        self._source = source
        self.prefixes: dict[str, str] = {}
        parser = expat.ParserCreate(namespace_separator="|")
        parser.StartElementHandler = start
        parser.EndElementHandler = end
        parser.StartNamespaceDeclHandler = self._declared
        parser.StartDoctypeDeclHandler = self._refuse_document_type
        self._parser = parser

    def feed(self, chunks: Iterable[bytes]) -> None:
        """Reads a whole document. Raises FileError with the line where it is not XML or has a document type."""
        try:
            fed = 0
            for chunk in chunks:
                self._parser.Parse(chunk, False)
                fed += len(chunk)
                if fed - max(self._parser.CurrentByteIndex, 0) > _LONGEST + len(chunk):
                    raise self.error(f"a tag or comment of more than {_LONGEST >> 20} MiB, the longest that is read")
            self._parser.Parse(b"", True)
        except expat.ExpatError as error:
            raise FileError(f"{self._source}: not XML: {error}; the file is damaged; write or copy it again") from None
        except (LookupError, ValueError) as error:  # of an encoding that Python does not have or cannot map
            raise self.error(f"its characters cannot be read: {shown(str(error), 120)}; write it in UTF-8") from None

    def error(self, text: str) -> FileError:
        """A refusal that says in which line."""
        return FileError(f"{self._source}, line {self._parser.CurrentLineNumber}: {text}")

    def _declared(self, prefix: str | None, uri: str | None) -> None:
        self.prefixes[prefix or ""] = uri or ""

    def _refuse_document_type(self, *_: object) -> NoReturn:
        raise self.error(
            "has a document type (DOCTYPE), which 3MF does not allow: its entities can stand for any amount"
            " of text; write the file again without"
        )
