"""Spoilt files: what happens to bytes on their way, and what people and programs do to numbers and lines."""

from __future__ import annotations

import random
import re

NUMBERS = [b"0", b"-1", b"1", b"-0.0", b"2147483647", b"2147483648", b"-2147483649", b"4294967295", b"4294967296",
           b"9223372036854775808", b"1e999", b"-1e999", b"1e-999", b"nan", b"-inf", b"0x10", b"1_0", b"1,5", b".",
           b"1e", b"9" * 70, b"0." + b"0" * 40 + b"1", b"1e99999999999999999999", b"1/", b"//", b"-"]  # fmt: skip
WORDS = [4, 8, 2, 1]
VALUES = [0, -1, 1, 2**31 - 1, -(2**31), 2**32 - 1, 2**16, 255, 2**63 - 1]
_NUMBER = re.compile(rb"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")


def _flip(data, chance, others):
    for _ in range(chance.randint(1, 8)):
        place = chance.randrange(len(data))
        data[place] ^= 1 << chance.randrange(8)
    return data


def _cut(data, chance, others):
    return data[: chance.randrange(len(data))]


def _drop(data, chance, others):
    place = chance.randrange(len(data))
    del data[place : place + chance.choice([1, 1, 2, 4, 50])]
    return data


def _insert(data, chance, others):
    place = chance.randrange(len(data) + 1)
    added = chance.choice([b"\0", b"\xff" * 4, b"\n", b" ", b"#", b"\\\n", b"\r", b"/", b"-", chance.randbytes(5)])
    data[place:place] = added * chance.choice([1, 1, 1, 300])
    return data


def _splice(data, chance, others):
    other = chance.choice(others)
    return data[: chance.randrange(len(data))] + other[chance.randrange(len(other)) :]


def _number(data, chance, others):
    """A number of the text replaced."""
    found = list(_NUMBER.finditer(data))
    if not found:
        return _binary_number(data, chance, others)
    for one in sorted(chance.sample(found, min(len(found), chance.choice([1, 1, 1, 3]))), key=lambda m: -m.start()):
        data[one.start() : one.end()] = chance.choice(NUMBERS)
    return data


def _binary_number(data, chance, others):
    size = min(chance.choice(WORDS), len(data))
    place = chance.randrange(len(data) - size + 1)
    value = chance.choice(VALUES) % 2 ** (8 * size)
    data[place : place + size] = value.to_bytes(size, chance.choice(["little", "big"]))
    return data


def _line(data, chance, others):
    """A line doubled, removed, or moved."""
    lines = data.split(b"\n")
    k = chance.randrange(len(lines))
    line = lines[k]
    match chance.randrange(4):
        case 0:
            lines[k:k] = [line] * chance.choice([1, 1, 20])
        case 1:
            del lines[k]
        case 2:
            lines.insert(chance.randrange(len(lines) + 1), lines.pop(k))
        case _:
            lines.insert(k, chance.choice(bytes(chance.choice(others)).split(b"\n")))
    return bytearray(b"\n".join(lines))


def _word(data, chance, others):
    """A word replaced by one of the same or another file."""
    words = bytes(data).split(b" ")
    words[chance.randrange(len(words))] = chance.choice(bytes(chance.choice(others)).split())
    return bytearray(b" ".join(words))


MUTATIONS = [_flip, _cut, _drop, _insert, _splice, _number, _number, _binary_number, _line, _word]


def once(data, chance, others):
    """One mutation of bytes, without any regard to what they are."""
    return bytearray(chance.choice(MUTATIONS)(data, chance, others))


def spoilt(corpus: list[bytes], seed: str, own=None) -> bytes:
    """One of the files with one to four mutations; the same for the same seed.

    own   a mutation that knows the format: three of four files get only this one
    """
    chance = random.Random(seed)
    data = bytearray(chance.choice(corpus))
    if own and chance.random() < 0.75:
        return bytes(own(data, chance, corpus))
    for _ in range(chance.choice([1, 1, 2, 4])):
        if data:
            data = once(data, chance, corpus)
    return bytes(data)
