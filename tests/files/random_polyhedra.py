"""Polyhedra with faces of mixed sizes, and writers of them in many styles, written apart from the readers."""

from __future__ import annotations

import struct
from dataclasses import dataclass

import numpy as np

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}
NEW_NAMES = {
    "char": "int8", "uchar": "uint8", "short": "int16", "ushort": "uint16", "int": "int32", "uint": "uint32",
    "float": "float32", "double": "float64",
}  # fmt: skip


@dataclass(frozen=True)
class Shape:
    """Vertices as tuples, faces as lists of their numbers; every vertex has a face."""

    vertices: list
    faces: list


def prism(corners, scale=1.0):
    """A prism over a regular polygon: two faces of that many corners, the others of four."""
    turn = 2 * np.pi * np.arange(corners) / corners
    ring = [(scale * x, scale * y) for x, y in zip(np.cos(turn).tolist(), np.sin(turn).tolist(), strict=True)]
    around = range(corners)
    faces = [list(around)[::-1], [corners + k for k in around]]
    faces += [[k, (k + 1) % corners, corners + (k + 1) % corners, corners + k] for k in around]
    return Shape([(*p, 0.0) for p in ring] + [(*p, scale) for p in ring], faces)


def random_shape(random):
    """Prisms of random sizes side by side, some faces cut into triangles, faces in random order."""
    vertices, faces = [], []
    for _ in range(random.integers(1, 4)):
        part = prism(int(random.integers(3, 9)), float(10.0 ** random.uniform(-6, 6)))
        shift, first = random.normal(size=3) * 10.0 ** random.uniform(-3, 3), len(vertices)
        vertices += [tuple((np.array(v) + shift).tolist()) for v in part.vertices]
        for face in part.faces:
            own = [first + k for k in face]
            cut = [[own[0], own[k], own[k + 1]] for k in range(1, len(own) - 1)]
            faces += cut if random.random() < 0.3 else [own]
    random.shuffle(faces)
    return Shape(vertices, faces)


def faces_of(body):
    """The coordinates of every face of a body, face after face."""
    return [
        body.vertices[body.indices[start:end]].tolist()
        for start, end in zip(body.offsets[:-1], body.offsets[1:], strict=True)
    ]


def expected(shape):
    return [[list(shape.vertices[k]) for k in face] for face in shape.faces]


def number(random, value):
    """The number in one of the ways that give it back."""
    style = random.integers(4)
    text = (repr(value), f"{value:.17g}", f"{value:.16e}", f"{value:.20e}".replace("e", "E"))[style]
    return f"+{text}" if value > 0 and random.random() < 0.1 else text


def _line(random, words, end):
    gap = random.choice([" ", "  ", "\t", " \t "])
    return random.choice(["", " ", "\t"]) + gap.join(words) + random.choice(["", " "]) + end


def obj(shape, random):
    """An OBJ file whose faces may come between the vertices, with normals, texture and colours at random."""
    end = random.choice(["\n", "\r\n", "\r"]) if random.random() < 0.8 else "\n"
    lines, written = [], 0
    added = random.choice(["", "1.0", "0.5 nan 0.25"])
    ready = [max(face) for face in shape.faces]
    left = list(range(len(shape.faces)))
    early = random.random() < 0.5

    def face(k):
        form = random.choice(["{}", "{}/1", "{}//1", "{}/1/1", "{}//"])
        words = [form.format(v - written if random.random() < 0.5 else v + 1) for v in shape.faces[k]]
        text = _line(random, ["f", *words], end)
        if random.random() < 0.2 and end != "\r":
            text = text.replace(" ", f" \\{end}", 1) if " " in text.strip() and text[0] == "f" else text
        lines.append(text)

    for vertex in shape.vertices:
        lines.append(_line(random, ["v", *(number(random, x) for x in vertex), *added.split()], end))
        written += 1
        if random.random() < 0.2:
            lines.append(random.choice(["# a comment", "", "vt 0 1", "vn 0 0 1", "usemtl steel", "s off"]) + end)
        while early and left and ready[left[0]] < written:
            face(left.pop(0))
    for k in left:
        face(k)
    return "".join(lines).encode()


def off(shape, random):
    """An OFF file in text, perhaps with normals or colours."""
    kind = random.choice(["", "C", "N", "CN", "STC"])
    more = " ".join(["0.5"] * (3 * ("N" in kind) + 4 * ("C" in kind) + 2 * ("ST" in kind)))
    end = random.choice(["\n", "\r\n", "\r"])
    counts = f"{len(shape.vertices)} {len(shape.faces)}" + random.choice(["", " 0", " 17"])
    lines = ["# made by hand" + end] if random.random() < 0.3 else []
    lines.append(f"{kind}OFF" + random.choice([" ", end, f" # counts{end}"]) + counts + end)
    for vertex in shape.vertices:
        lines.append(_line(random, [*(number(random, x) for x in vertex), *more.split()], end))
        if random.random() < 0.1:
            lines.append(random.choice(["# between", "", "   "]) + end)
    for face in shape.faces:
        colour = random.choice(["", "255 0 0", "0.1 0.2 0.3 1", "12"])
        lines.append(_line(random, [str(len(face)), *map(str, face), *colour.split()], end))
    return "".join(lines).encode()


def off_binary(shape, random):
    """A binary OFF file; its coordinates are in single precision."""
    kind = random.choice(["", "C", "N", "CN", "STCN"])
    more = 3 * ("N" in kind) + 4 * ("C" in kind) + 2 * ("ST" in kind)
    data = f"{kind}OFF BINARY\n".encode() + struct.pack(">3i", len(shape.vertices), len(shape.faces), 7)
    for vertex in shape.vertices:
        data += struct.pack(f">{3 + more}f", *vertex, *[0.5] * more)
    for face in shape.faces:
        colours = int(random.integers(0, 5))
        data += struct.pack(f">{1 + len(face)}i", len(face), *face) + struct.pack(
            f">i{colours}f", colours, *[1] * colours
        )
    return data


def ply(shape, random, form, type_):
    """A PLY file with properties in random order, others between them, and other elements around."""
    name = (lambda t: NEW_NAMES[t]) if random.random() < 0.5 else (lambda t: t)
    vertex = [("x", type_, None), ("y", type_, None), ("z", type_, None)]
    vertex += [("red", "uchar", None), ("quality", "double", None), ("near", "short", "uchar")][: random.integers(0, 4)]
    count = str(random.choice(["char", "uchar", "short", "ushort", "int", "uint"]))
    item = str(random.choice(["char", "uchar", "short", "ushort", "int", "uint"]))
    face = [(str(random.choice(["vertex_indices", "vertex_index"])), item, count)]
    face += [("flags", "ushort", None), ("texcoord", "float", "int")][: random.integers(0, 3)]
    random.shuffle(vertex)
    random.shuffle(face)
    elements = [("vertex", vertex, len(shape.vertices)), ("face", face, len(shape.faces))]
    if random.random() < 0.3:
        elements.reverse()
    other = ("edge", [("vertex1", "int", None), ("weights", "double", "uchar")], int(random.integers(0, 4)))
    elements.insert(int(random.integers(0, 3)), other)
    end = "\n" if random.random() < 0.7 else "\r\n"
    header = ["ply", f"format {form} 1.0", "comment element vertex 5"]
    for called, properties, rows in elements:
        header.append(f"element {called} {rows}")
        header += [f"property {f'list {name(c)} ' if c else ''}{name(t)} {p}" for p, t, c in properties]
    data = end.join([*header, "obj_info end_header", "end_header", ""]).encode()
    for called, properties, rows in elements:
        for row in range(rows):
            data += _row(shape, random, called, properties, row, form, end)
    return data


def _row(shape, random, called, properties, row, form, end):
    order = "<" if form == "binary_little_endian" else ">"
    words, data = [], b""
    for p, t, c in properties:
        if p in ("x", "y", "z"):
            values = [shape.vertices[row]["xyz".index(p)]]
        elif p.startswith("vertex_ind"):
            values = shape.faces[row]
        else:
            values = random.integers(0, 100, random.integers(0, 4) if c else 1).tolist()
        values = [float(v) if t in ("float", "double") else int(v) for v in values]
        data += struct.pack(order + (TYPES[c] if c else ""), *[len(values)] * bool(c))
        data += struct.pack(order + TYPES[t] * len(values), *values)
        words += [str(len(values))] * bool(c) + [number(random, v) if isinstance(v, float) else str(v) for v in values]
    return _line(random, words, end).encode() if form == "ascii" else data


def stl_text(shape, random):
    """Every triangle of a fan of each face, in one solid."""
    end = random.choice(["\n", "\r\n", "\r"])
    lines = ["solid part of many words" + end]
    for a, b, c in triangles(shape):
        lines.append(_line(random, ["facet", "NORMAL", "0", "-1e-3", "nan"], end) + "outer loop" + end)
        corners = ([number(random, x) for x in shape.vertices[k]] for k in (a, b, c))
        lines += [_line(random, ["vertex", *words], end) for words in corners]
        lines.append("endloop" + random.choice([end, " "]) + "EndFacet" + end)
    return "".join([*lines, "endsolid", random.choice(["", end, " x"])]).encode()


def triangles(shape):
    return [(face[0], face[k], face[k + 1]) for face in shape.faces for k in range(1, len(face) - 1)]


def in_single(shape):
    """The shape with coordinates in single precision."""
    return Shape([tuple(np.float32(v).astype(float).tolist()) for v in shape.vertices], shape.faces)
