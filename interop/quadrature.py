"""Open CASCADE's adaptive quadrature, of which its own programs show the plain one."""

from typing import Any


def volume(shape: Any) -> float:
    """Of a solid, by Gauss–Kronrod rules over its faces within 1e-9."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    found = GProp_GProps()
    error = BRepGProp.VolumePropertiesGK_s(shape, found, 1e-9, False, True, False, False)
    assert error >= 0.0
    return float(found.Mass())
