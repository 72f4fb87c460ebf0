"""Densities of engineering materials by name, and of any material in the units of a body."""

from __future__ import annotations

from dataclasses import dataclass

from .errors import ParameterError, Problem
from .parameters import LENGTH_UNITS, Parameter, did_you_mean

DENSITY = Parameter(meaning="density in kg/m³", above=0)


@dataclass(frozen=True, kw_only=True)
class Material:
    """A material as handbooks list it.

    density  kg/m³ at room temperature, a typical value
    remark   which grade or state that is, or how far others are from it
    aliases  other names that find it
    """

    name: str
    density: float
    remark: str
    aliases: tuple[str, ...] = ()


def _made(name: str, density: float, remark: str, *aliases: str) -> Material:
    return Material(name=name, density=density, remark=remark, aliases=aliases)


MATERIALS = (
    _made(
        "steel", 7850, "unalloyed and low-alloy steel, as structural standards take it", "carbon steel", "mild steel"
    ),
    _made("stainless steel", 7900, "austenitic, 1.4301 (AISI 304); ferritic 7700", "inox", "304"),
    _made("tool steel", 7800, "cold-work steel; high-speed steel up to 8200"),
    _made("grey cast iron", 7200, "EN-GJL-250; 7100 to 7300", "gray cast iron", "cast iron"),
    _made("ductile cast iron", 7100, "EN-GJS-400; 7000 to 7200", "nodular cast iron", "spheroidal cast iron"),
    _made("aluminium", 2700, "unalloyed and 6000 series; 7075 is 2810", "aluminum"),
    _made("magnesium", 1800, "cast alloy AZ91; unalloyed 1740"),
    _made("titanium", 4430, "Ti-6Al-4V; unalloyed 4510"),
    _made("copper", 8960, "unalloyed, wrought"),
    _made("brass", 8500, "CuZn37 8440 to CuZn39Pb3 8470, rounded as usual"),
    _made("bronze", 8800, "tin bronze CuSn8; aluminium bronze 7600"),
    _made("nickel", 8900, "unalloyed"),
    _made("zinc alloy", 6700, "die-casting alloy ZnAl4Cu1", "zinc", "zamak"),
    _made("lead", 11340, "unalloyed"),
    _made("tungsten", 19300, "unalloyed; heavy metal for balancing weights 17000 to 18500"),
    _made("POM", 1410, "copolymer; homopolymer 1420", "acetal", "delrin", "polyoxymethylene"),
    _made("PA6", 1140, "dry", "nylon 6", "polyamide 6"),
    _made("PA66", 1140, "dry", "nylon 66", "nylon", "polyamide 66"),
    _made("PA66-GF30", 1370, "30 % glass fibre by mass, dry"),
    _made("PEEK", 1310, "unfilled, 1300 to 1320"),
    _made("PC", 1200, "unfilled", "polycarbonate"),
    _made("ABS", 1050, "unfilled, 1030 to 1070"),
    _made("PLA", 1240, "solid; a print with infill is lighter"),
    _made("PETG", 1270, "solid; a print with infill is lighter"),
    _made("PP", 905, "unfilled, 900 to 910", "polypropylene"),
    _made("PE-HD", 955, "unfilled, 940 to 970", "hdpe", "polyethylene"),
    _made("PTFE", 2170, "unfilled, 2130 to 2200", "teflon"),
    _made("PMMA", 1190, "cast", "acrylic", "plexiglass"),
    _made("polyurethane", 1200, "cast elastomer, 1050 to 1250; foam is far lighter", "PU", "PUR"),
    _made("rubber", 1200, "filled, 1100 to 1300"),
    _made("CFRP", 1550, "carbon fibre in epoxy, 60 % by volume", "carbon fibre", "carbon fiber"),
    _made("alumina", 3900, "dense ceramic, 99 %"),
    _made("oak", 700, "12 % moisture; 600 to 800"),
    _made("concrete", 2400, "plain, compacted"),
    _made("water", 998, "20 °C"),
)


def material(name: str) -> Material:
    """The material of a name or alias; case, hyphens and underscores do not matter.

    Raises ParameterError where there is none, with the names nearest to it.
    """
    names = {_plain(known): one for one in MATERIALS for known in (one.name, *one.aliases)}
    given = _plain(name)
    if given not in names:
        known = ", ".join(one.name for one in MATERIALS)
        hint = did_you_mean(given, names)
        problem = Problem(f"material = {name!r}", f"there is no such one{hint}; known are {known}, or give a density")
        raise ParameterError("A density", [problem])
    return names[given]


def density(material_or_density: str | float, *, length_unit: str = "mm") -> float:
    """Mass per cubed length unit, in kg, as `properties(density=…)` takes it.

    material_or_density  the name of a material, or kg/m³

    Raises ParameterError, all problems together, where it is neither or the unit is none of LENGTH_UNITS.
    """
    problems: list[Problem] = []
    value = material_or_density
    if isinstance(material_or_density, str):
        try:
            value = material(material_or_density).density
        except ParameterError as error:
            problems += error.problems
    elif problem := DENSITY.problem(material_or_density):
        problems.append(Problem(f"density = {material_or_density!r} kg/m³", problem))
    if length_unit not in LENGTH_UNITS:
        hint = did_you_mean(length_unit, LENGTH_UNITS)
        problems.append(Problem(f"length_unit = {length_unit!r}", f"choose one of {', '.join(LENGTH_UNITS)}{hint}"))
    if problems:
        raise ParameterError("A density", problems)
    return float(value) / (1e3 / LENGTH_UNITS[length_unit]) ** 3


def _plain(name: str) -> str:
    return " ".join(name.casefold().replace("-", " ").replace("_", " ").split())
