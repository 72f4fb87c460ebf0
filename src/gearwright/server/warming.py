"""What a worker loads before its first job, so that a replaced one answers as fast as the one before."""

from __future__ import annotations


def warm() -> None:
    """Builds a small pair with its polyhedra, which loads the libraries and the compiled functions."""
    from ..designs.built import built_from
    from ..designs.design import design_of

    for teeth in ([12, 13], 12):
        design = design_of({"element": "spur", "teeth": teeth, "module": 1.0, "face_width": 5.0})
        element, _ = design.element()
        built_from(design.kind, element, None, 0.0)
        element.assembly()
