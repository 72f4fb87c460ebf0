"""Which of a pair's parameters go to which member, and which values go to none."""

from __future__ import annotations

from typing import Any

from ...parameters import declarations, member_value


def values_of_member(pair: object, member: int, element: type) -> dict[str, Any]:
    """The parameters of a pair that one member (0 pinion, 1 gear), built as that element, has as well.

    One height of the tip relief does for whichever member is relieved.
    """
    own = {one.name for one in declarations(type(pair))}
    names = [one.name for one in declarations(element) if one.name in own]
    values = {name: member_value(getattr(pair, name), member) for name in names}
    if "tip_relief_height" in values and not values["tip_relief"] and _one_relief_height(pair):
        values["tip_relief_height"] = None
    return values


def _one_relief_height(pair: Any) -> bool:
    """Whether one height is given, and a member that is relieved."""
    reliefs = [member_value(pair.tip_relief, member) for member in (0, 1)]
    return any(reliefs) and not isinstance(pair.tip_relief_height, tuple)


def second_values_without_use(pair: object, element: type) -> list[str]:
    """Names of parameters given twice, though a gear built as that element has no such parameter."""
    used = {one.name for one in declarations(element)}
    given = {one.name: getattr(pair, one.name) for one in declarations(type(pair)) if one.members == "both"}
    nothing = (None, 0.0, "none")
    return [
        name
        for name, value in given.items()
        if name not in used and isinstance(value, tuple) and value[1] not in nothing
    ]
