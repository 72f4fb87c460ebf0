"""Extensions of 3MF: which change the shape of bodies, so that a mesh alone is not the body."""

from __future__ import annotations

from ...errors import FileError
from ..text.places import shown

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"

_SHAPING = {
    "beamlattice": "beam lattices",
    "slice": "slice stacks",
    "booleanoperations": "Boolean operations",
    "volumetric": "volumetric data",
    "implicit": "implicit shapes",
    "displacement": "displaced surfaces",
    "securecontent": "encrypted parts",
}
"""What an extension brings, by the word of its namespace's path before the date."""

_HARMLESS = ("core", "production", "material", "trianglesets")


def require_known(file: str, uri: str) -> None:
    """Raises FileError if an extension that a model requires changes the shape of bodies, or may, being unknown.

    Source: 3MF Core Specification 1.3, section 2.3: what requires an extension that a reader does not know is not read.
    """
    word = _word(uri)
    if word in _SHAPING:
        raise FileError(
            f"{file}: requires the 3MF extension for {_SHAPING[word]} ({shown(uri, 120)}), which changes the shape of"
            " bodies and is not read; export plain meshes"
        )
    if word not in _HARMLESS:
        raise FileError(
            f"{file}: requires the 3MF extension {shown(uri, 120)}, which is not known here and so may change the shape"
            " of bodies; export plain meshes"
        )


def remark_about(uri: str) -> str | None:
    """A remark about an extension that is used where meshes do without it; None where it leaves these as they are."""
    word = _word(uri)
    return f"{_SHAPING[word]} (a 3MF extension) left out: bodies are their meshes" if word in _SHAPING else None


def _word(uri: str) -> str:
    """ "beamlattice" of ".../3dmanufacturing/beamlattice/2017/02"; any version means the same here."""
    _, found, rest = uri.partition("/3dmanufacturing/")
    return rest.partition("/")[0] if found else ""
