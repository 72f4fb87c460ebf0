"""Geometric modelling of gears, cams and swept solids, with exact volumetric properties.

Public names load when first used, so that `import gearwright` itself loads no numpy.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    from .contact.lines import contact_lines, contact_ratios
    from .contact.overlap import overlap_through_cycle
    from .contact.transmission import transmission_error
    from .curves.helix import helix
    from .elements.bevel.bevel_gear import BevelGear
    from .elements.bevel.bevel_pair import BevelPair
    from .elements.cams.cam import Cam
    from .elements.cylindrical.gear_pair import GearPair
    from .elements.cylindrical.helical_gear import HelicalGear
    from .elements.cylindrical.herringbone_gear import HerringboneGear
    from .elements.cylindrical.internal_gear import InternalGear
    from .elements.cylindrical.rack import Rack
    from .elements.cylindrical.spur_gear import SpurGear
    from .elements.sheets import SheetLabels
    from .elements.sweep import Sweep
    from .errors import FileError, GearwrightError, GeometryError, MachineError, ParameterError, Problem
    from .materials import MATERIALS, Material, density
    from .moments.bare import mass_properties
    from .sections.plane import Section
    from .solids.approximation import approximation_error, layer_refinement, section_refinement
    from .solids.convergence import ApproximationError, plot_convergence
    from .solids.model import Model
    from .solids.polyhedron import Polyhedron
    from .solids.properties import MassProperties
    from .solids.streamed import stream_properties
    from .solids.sweeps import extrude, revolve, sweep, sweep_along
    from .studies.agreement import compare

__all__ = [
    "MATERIALS",
    "ApproximationError",
    "BevelGear",
    "BevelPair",
    "Cam",
    "FileError",
    "GearPair",
    "GearwrightError",
    "GeometryError",
    "HelicalGear",
    "HerringboneGear",
    "InternalGear",
    "MachineError",
    "MassProperties",
    "Material",
    "Model",
    "ParameterError",
    "Polyhedron",
    "Problem",
    "Rack",
    "Section",
    "SheetLabels",
    "SpurGear",
    "Sweep",
    "__version__",
    "approximation_error",
    "compare",
    "contact_lines",
    "contact_ratios",
    "density",
    "extrude",
    "helix",
    "layer_refinement",
    "mass_properties",
    "overlap_through_cycle",
    "plot_convergence",
    "revolve",
    "section_refinement",
    "stream_properties",
    "sweep",
    "sweep_along",
    "transmission_error",
]

_MODULES = {
    ".contact.lines": ("contact_lines", "contact_ratios"),
    ".contact.overlap": ("overlap_through_cycle",),
    ".contact.transmission": ("transmission_error",),
    ".curves.helix": ("helix",),
    ".elements.bevel.bevel_gear": ("BevelGear",),
    ".elements.bevel.bevel_pair": ("BevelPair",),
    ".elements.cylindrical.gear_pair": ("GearPair",),
    ".elements.cylindrical.helical_gear": ("HelicalGear",),
    ".elements.cylindrical.herringbone_gear": ("HerringboneGear",),
    ".elements.cylindrical.internal_gear": ("InternalGear",),
    ".elements.cylindrical.rack": ("Rack",),
    ".elements.cylindrical.spur_gear": ("SpurGear",),
    ".elements.cams.cam": ("Cam",),
    ".elements.sheets": ("SheetLabels",),
    ".elements.sweep": ("Sweep",),
    ".errors": ("FileError", "GearwrightError", "GeometryError", "MachineError", "ParameterError", "Problem"),
    ".moments.bare": ("mass_properties",),
    ".materials": ("MATERIALS", "Material", "density"),
    ".sections.plane": ("Section",),
    ".solids.approximation": ("approximation_error", "layer_refinement", "section_refinement"),
    ".solids.convergence": ("ApproximationError", "plot_convergence"),
    ".solids.model": ("Model",),
    ".solids.polyhedron": ("Polyhedron",),
    ".solids.properties": ("MassProperties",),
    ".solids.streamed": ("stream_properties",),
    ".solids.sweeps": ("extrude", "revolve", "sweep", "sweep_along"),
    ".studies.agreement": ("compare",),
}
_HOMES = {name: module for module, names in _MODULES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = globals()[name] = getattr(import_module(_HOMES[name], __name__), name)
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
