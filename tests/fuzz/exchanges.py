"""Spoilt exchange files (ISO 10303-21): their entities changed, between a beginning and an end that stay whole."""

from __future__ import annotations

import re

from .mutations import once

_REFERENCE = re.compile(rb"#\d+")


def spoilt_exchange(data, chance, others):
    """The file with one to three changes between DATA and the end, else it is refused before anything is read."""
    start, end = data.find(b"DATA;") + 5, data.rfind(b"ENDSEC;")
    if not 5 <= start < end:
        return once(data, chance, others)
    inside = data[start:end]
    for _ in range(chance.choice([1, 1, 2, 3])):
        if inside:
            inside = (_reference if chance.random() < 0.5 else once)(inside, chance, others)
    return data[:start] + inside + data[end:]


def _reference(data, chance, others):
    """A reference to an entity replaced by another one."""
    found = list(_REFERENCE.finditer(data))
    if not found:
        return data
    one = chance.choice(found)
    return data[: one.start()] + chance.choice([chance.choice(found)[0], b"#99999", b"$", b"*"]) + data[one.end() :]
