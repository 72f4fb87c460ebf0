"""One command for each name in the catalog: parameters in, sizes, properties and files out."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial

from .. import catalog
from ..designs.kinds import article, chosen, element_of, kinds_of, option_name, parameter_names, parameters_of, said
from ..errors import ProblemsError
from .common_options import DEFAULT, FLATTENED, Outputs
from .deliver import deliver
from .options import given_values, offered, signature_parameters
from .output_problems import output_problems
from .wording import in_options, text_in_options

Words = Mapping[str, Sequence[str] | None]


@cache
def __getattr__(name: str) -> Callable[..., int]:
    """The command of a name that the catalog's elements have."""
    kinds = kinds_of(name)
    if not kinds:
        raise AttributeError(f"the catalog has no element with the command {name!r}")
    return _command(name, kinds)


def _command(name: str, kinds: Sequence[catalog.Element]) -> Callable[..., int]:
    """A function whose signature is the union of the parameters of the kinds, and the common options."""
    parameters = offered({kind.name: parameters_of(kind) for kind in kinds})

    def run(*, outputs: Outputs = DEFAULT, **words: Sequence[str] | None) -> int:
        kind = chosen(kinds, words.get("teeth") or None)
        element, problems = element_of(kind, kinds, given_values(parameters, words), option_name)
        problems = in_options(problems, kinds) + output_problems(outputs, kind)
        if problems:
            subject = f"{article(kind.name).capitalize()} {said(kind, kinds, option_name)}"
            raise ProblemsError(f"{subject} cannot be built with these options", problems)
        return deliver(kind, element, outputs, partial(text_in_options, names=parameter_names(kind)))

    common = inspect.Parameter("outputs", inspect.Parameter.KEYWORD_ONLY, default=DEFAULT, annotation=FLATTENED)
    signature = inspect.Signature([*signature_parameters(parameters), common], return_annotation=int)
    run.__name__ = run.__qualname__ = name
    run.__signature__ = signature  # type: ignore[attr-defined]
    run.__annotations__ = {p.name: p.annotation for p in signature.parameters.values()}
    return run
