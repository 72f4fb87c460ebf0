"""Spoilt scenes: JSON that is whole but says something else, and the bytes that it describes."""

from __future__ import annotations

import base64
import copy
import json
import struct

from .mutations import once

_INTERESTING = [0, 1, -1, 2, 3, 5, 255, 2**31, 2**32, 2**53, 2**63, 10**30, 0.5, 3.0, 1e308, -1e308, 1e-320, 5e38, True,
                None, "", "x\n" * 300, "VEC3", "SCALAR", "KHR_materials_unlit", "../x", "data:,", [], [0], [[0]], {},
                [0] * 16, [1e200] * 16, {"count": 1}, 5120, 5121, 5126]  # fmt: skip
_DATA = "data:application/octet-stream;base64,"


def spoilt_scene(data, chance, others):
    """The scene with one to three changes in its document or its numbers; other bytes as they come."""
    opened = _opened(bytes(data))
    if opened is None:
        return once(data, chance, others)
    document, binary = opened
    for _ in range(chance.choice([1, 1, 2, 3])):
        if chance.random() < 0.2:
            binary = _other_numbers(document, binary, chance, others)
        else:
            _changed(document, chance)
    text = json.dumps(document).encode()
    return bytearray(text if binary is None else _container(text, binary))


def _changed(document, chance):
    """A value replaced, left away, doubled, or put in the place of another."""
    places = list(_places(document))
    if not places:
        return
    holder, key = chance.choice(places)
    match chance.randrange(8):
        case 0:
            del holder[key]
        case 1 if isinstance(holder, list):
            holder.extend([holder[key]] * chance.choice([1, 1, 100]))
        case 2:
            other, from_key = chance.choice(places)
            holder[key] = copy.deepcopy(other[from_key])
        case _:
            holder[key] = copy.deepcopy(chance.choice(_INTERESTING))


def _places(value):
    """All members of objects and lists, however deep, as what holds them and their keys."""
    keys = range(len(value)) if isinstance(value, list) else list(value) if isinstance(value, dict) else ()
    for key in keys:
        yield value, key
        yield from _places(value[key])


def _other_numbers(document, binary, chance, others):
    """Changed bytes of the binary chunk, or else of the first buffer inside the document; gives the chunk."""
    if binary:
        return bytes(once(bytearray(binary), chance, others))
    buffers = document.get("buffers")
    buffer = buffers[0] if isinstance(buffers, list) and buffers else None
    uri = buffer.get("uri") if isinstance(buffer, dict) else None
    if isinstance(uri, str) and uri.startswith(_DATA) and len(uri) > len(_DATA) + 4:
        try:
            numbers = bytearray(base64.b64decode(uri.removeprefix(_DATA)))
        except ValueError:
            return binary
        buffer["uri"] = _DATA + base64.b64encode(once(numbers, chance, others)).decode()
    return binary


def _opened(data):
    """The document and the binary chunk of a scene; None where it is none."""
    try:
        if data[:4] != b"glTF":
            found, binary = json.loads(data), None
        else:
            length = struct.unpack_from("<I", data, 12)[0]
            found, binary = json.loads(data[20 : 20 + length]), data[28 + length :]
    except (ValueError, struct.error):
        return None
    return (found, binary) if isinstance(found, dict) else None


def _container(text, binary):
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)) + struct.pack("<I4s", len(text), b"JSON")
    return head + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
