"""Drawings that the tests make, and what they must come to."""

from pathlib import Path

import numpy as np

SVG = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"{}>{}</svg>'


def dxf(folder, draw, **header):
    """A DXF file of what `draw(document, modelspace)` puts into it."""
    import ezdxf

    document = ezdxf.new("R2010")
    for name, value in header.items():
        document.header[f"${name}"] = value
    draw(document, document.modelspace())
    path = Path(folder) / "drawing.dxf"
    document.saveas(path)
    return path


def svg(folder, body, page=""):
    path = Path(folder) / "drawing.svg"
    path.write_text(SVG.format(page and " " + page, body))
    return path


def csv(folder, text):
    path = Path(folder) / "drawing.csv"
    path.write_text(text)
    return path


def polygon_moments(points):
    """Area, ∫ x dA, ∫ y dA, ∫ x² dA, ∫ xy dA, ∫ y² dA of a polygon, by triangles from the origin."""
    a, b = np.asarray(points, float), np.roll(points, -1, axis=0)
    area = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2.0
    first = (a + b) / 3.0 * area[:, None]
    outer = [np.einsum("i,ij,ik->jk", area, p, q) for p, q in ((a, a), (b, b), (a + b, a + b))]
    second = sum(outer) / 12.0
    return np.array([area.sum(), *first.sum(axis=0), second[0, 0], second[0, 1], second[1, 1]])


def section_moments(section):
    m = section.moments
    return np.array([m[0, 0], m[1, 0], m[0, 1], m[2, 0], m[1, 1], m[0, 2]])
