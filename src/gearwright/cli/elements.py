"""One command for each name in the catalog: parameters in, sizes, properties and files out."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any

from .. import catalog
from ..errors import ParameterError, Problem, ProblemsError
from ..parameters import declarations, from_mapping
from .built import built_from
from .common_options import DEFAULT, FLATTENED, Outputs
from .convergence import plot_parts, show_convergence, with_convergence
from .exits import DONE
from .json_output import built_json
from .options import given_values, offered, option_name, signature_parameters, teeth_given
from .outputs import write
from .report import show_built
from .wording import in_options, text_in_options

Words = Mapping[str, Sequence[str] | None]


@cache
def __getattr__(name: str) -> Callable[..., int]:
    """The command of a name that the catalog's elements have."""
    kinds = [kind for kind in catalog.ELEMENTS if kind.command == name]
    if not kinds:
        raise AttributeError(f"the catalog has no element with the command {name!r}")
    return _command(name, sorted(kinds, key=lambda kind: -kind.members))


def _command(name: str, kinds: Sequence[catalog.Element]) -> Callable[..., int]:
    """A function whose signature is the union of the parameters of the kinds, and the common options."""
    parameters = offered({kind.name: catalog.load(kind.source) for kind in kinds})

    def run(*, outputs: Outputs = DEFAULT, **words: Sequence[str] | None) -> int:
        kind = _chosen(kinds, words)
        values = given_values(parameters, words)
        element = _element(kind, kinds, values, outputs)
        built = built_from(kind, element, outputs.density, outputs.turn or 0.0)
        if outputs.convergence is not None:
            built = with_convergence(built)
        written = write(built, outputs)
        if outputs.plot is not None:
            plot_parts(built, outputs.plot)
            written.append(outputs.plot)
        print(built_json(built)) if outputs.json else show_built(built)
        if outputs.convergence is not None and not outputs.json:
            show_convergence(built)
        for remark in element.remarks:
            print(f"note: {text_in_options(remark, _names(kind))}", file=sys.stderr)
        for path in written:
            print(f"wrote {path}", file=sys.stderr)
        return DONE

    common = inspect.Parameter("outputs", inspect.Parameter.KEYWORD_ONLY, default=DEFAULT, annotation=FLATTENED)
    signature = inspect.Signature([*signature_parameters(parameters), common], return_annotation=int)
    run.__name__ = run.__qualname__ = name
    run.__signature__ = signature  # type: ignore[attr-defined]
    run.__annotations__ = {p.name: p.annotation for p in signature.parameters.values()}
    return run


def _chosen(kinds: Sequence[catalog.Element], words: Words) -> catalog.Element:
    """The pair where two numbers of teeth (or none) are given, the single part where there is one."""
    members = len(words.get("teeth") or (1, 2))
    return next((kind for kind in kinds if kind.members == members), kinds[0])


def _element(
    kind: catalog.Element, kinds: Sequence[catalog.Element], values: Mapping[str, Any], outputs: Outputs
) -> Any:
    """The element. Raises ProblemsError with all that is wrong with its options and the common ones."""
    own = _names(kind)
    problems = [
        Problem(option_name(name), f"applies to a {other.name} ({teeth_given(other)})")
        for other in kinds
        if other != kind
        for name in values
        if name in _names(other) and name not in own
    ]
    try:
        element = from_mapping(catalog.load(kind.source), {name: v for name, v in values.items() if name in own})
    except ParameterError as error:
        problems += in_options(error.problems, kinds)
    problems += outputs.problems(kind.members)
    if problems:
        raise ProblemsError(f"A {kind.name} ({teeth_given(kind)}) cannot be built with these options", problems)
    return element


def _names(kind: catalog.Element) -> set[str]:
    return {d.name for d in declarations(catalog.load(kind.source))}
