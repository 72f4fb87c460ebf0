"""Spoilt zip packages: parts that are whole but wrong inside, parts that are missing, doubled or named otherwise."""

from __future__ import annotations

import io
import re
import warnings
import zipfile

from .mutations import NUMBERS, once

_TAG = re.compile(rb"<[^<>]*>")
_VALUE = re.compile(rb'"[^"<>]*"')
_TEXTS = [b"", b"&#10;&#9;", b"x" * 3000, b"&#10;" * 300, b"/3D/3dmodel.model", b"../../x", b"%00", b"\xc3\xa9", b"p q",
          b"1 0 0 0 1 0 0 0 0 0 0 0", b"1e200 0 0 0 1e200 0 0 0 1e200 0 0 0"]  # fmt: skip


def spoilt_package(data, chance, others):
    """The package with one to three changes in its parts; other bytes as they come."""
    parts = _unpacked(bytes(data))
    if not parts:
        return once(data, chance, others)
    texts = [text for one in others for _, text in _unpacked(bytes(one))]
    for _ in range(chance.choice([1, 1, 2, 3])):
        parts = _changed(parts, texts, chance)
    return bytearray(_packed(parts, chance.choice([zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED])))


def _changed(parts, texts, chance):
    if not parts:
        return parts
    k = chance.randrange(len(parts))
    name, text = parts[k]
    match chance.randrange(20):
        case 0:
            return parts[:k] + parts[k + 1 :]
        case 1:
            return [*parts, (chance.choice([name, name.upper(), "/" + name, "x\n" * 200]), text)]
        case 2:
            return [*parts[:k], (name, chance.choice(texts)), *parts[k + 1 :]]
        case n if n < 7:
            text = once(bytearray(text), chance, texts) if text else text
        case n if n < 13:
            text = _tags(text, texts, chance)
        case _:
            text = _value(text, chance)
    return [*parts[:k], (name, bytes(text)), *parts[k + 1 :]]


def _tags(text, texts, chance):
    """A tag removed, doubled, put elsewhere, or one of another file put in."""
    tags = list(_TAG.finditer(text))
    if not tags:
        return text
    one, place = chance.choice(tags), chance.choice(tags).start()
    match chance.randrange(4):
        case 0:
            return text[: one.start()] + text[one.end() :]
        case 1:
            return text[: one.end()] + one[0] * chance.choice([1, 1, 500]) + text[one.end() :]
        case 2:
            return text[:place] + one[0] + text[place:]
        case _:
            more = _TAG.findall(chance.choice(texts)) or [b"<x/>"]
            return text[:place] + chance.choice(more) + text[place:]


def _value(text, chance):
    """The value of an attribute replaced: by a number, by one of the same text, or by what no one expects."""
    values = list(_VALUE.finditer(text))
    if not values:
        return text
    one = chance.choice(values)
    new = chance.choice([NUMBERS, _TEXTS, [value[0][1:-1] for value in values]])
    return text[: one.start()] + b'"' + chance.choice(new) + b'"' + text[one.end() :]


def _unpacked(data):
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            return [(member.filename, archive.read(member)) for member in archive.infolist()]
    except zipfile.BadZipFile:
        return []


def _packed(parts, method):
    stream = io.BytesIO()
    with warnings.catch_warnings(), zipfile.ZipFile(stream, "w", method) as archive:
        warnings.simplefilter("ignore")  # of parts with one name, which are wanted
        for name, text in parts:
            archive.writestr(zipfile.ZipInfo(name), text, method)
    return stream.getvalue()
