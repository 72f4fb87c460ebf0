"""A view that a notebook shows: bodies that one turns with the mouse, by touch or by keys."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from html import escape
from pathlib import Path

from ..disk import written_whole
from ..errors import FileError
from ..files.assembly import Assembly, Faceted, placed_vertices
from ..pictures.camera import View, suitable_view
from .document import built, page, turning_page
from .still import image, still
from .turning import AT_REST, Turning

_SIZE = (1200, 750)  # of a still picture, pixels
_HINT = "A still picture: the viewer's script is not built here. `make web` builds it (Node is needed); wheels hold it."


@dataclass(frozen=True, kw_only=True, eq=False)
class TurningView:
    """Parts where they stand, to be turned in a notebook or a browser.

    turnings   how each part moves with the pinion; none where nothing turns
    view       from where they are seen at first; None for a suitable one

    A notebook shows it where it is the last expression of a cell; `page` and `save` are for everything else. Nothing
    is loaded: script and geometry stand in the page, which forbids the browser to fetch anything.
    """

    title: str
    assembly: Assembly[Faceted]
    turnings: tuple[Turning, ...] = ()
    view: View | None = None

    @cached_property
    def page(self) -> str:
        """A whole HTML document; with a still picture where the viewer's script is not built."""
        if not built():
            return page(self.title, self._figure())
        turnings = self.turnings or (AT_REST,) * len(self.assembly.parts)
        return turning_page(self.title, self.assembly, turnings, self.view or self._suitable_view())

    def save(self, path: str | Path) -> None:
        """Writes the page into an HTML file, whole or not at all. Raises FileError, MachineError."""
        path = Path(path)
        if path.suffix.lower() not in (".html", ".htm"):
            raise FileError(f"{path}: a view is written as a page; end the name in .html")
        with written_whole(path) as stream:
            stream.write(self.page.encode())

    def _repr_html_(self) -> str:
        if not built():
            return self._figure()
        source = self.page.replace("&", "&amp;").replace('"', "&quot;")
        style = "width:100%;height:min(540px,80vh);border:0;border-radius:8px;display:block"
        return (
            f'<iframe srcdoc="{source}" sandbox="allow-scripts" title="{escape(self.title)}" style="{style}"></iframe>'
        )

    def __repr__(self) -> str:
        names = ", ".join(part.name for part in self.assembly.parts)
        return f"<TurningView of {names}: a notebook shows it, save('view.html') writes it>"

    def _figure(self) -> str:
        picture = image(still(self.title, self.assembly, self.view, _SIZE), self.title, 800)
        return f'<figure style="margin:0">{picture}<figcaption>{escape(_HINT)}</figcaption></figure>'

    def _suitable_view(self) -> View:
        return suitable_view([(placed_vertices(part), part.shape.simple_triangles()) for part in self.assembly.parts])
