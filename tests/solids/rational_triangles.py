"""How triangles meet, by clipping in rational numbers: slow, without any rounding, and by another route."""

from fractions import Fraction
from itertools import combinations


def meetings(vertices, triangles):
    """Pairs of triangles whose insides meet, and pairs that meet in more than shared corners without that."""
    points = [tuple(Fraction(float(x)) for x in vertex) for vertex in vertices]
    through, touching = set(), set()
    for s, t in combinations(range(len(triangles)), 2):
        first, second = ([points[i] for i in triangles[n]] for n in (s, t))
        if not any(normal(first)) or not any(normal(second)):
            continue
        common = intersection(first, second)
        if not common:
            continue
        middle = tuple(sum(p[k] for p in common) / len(common) for k in range(3))
        if inside(middle, first) and inside(middle, second):
            through.add((s, t))
        elif not all(spanned(p, [points[i] for i in set(triangles[s]) & set(triangles[t])]) for p in common):
            touching.add((s, t))
    return through, touching


def intersection(first, second):
    """Corners of what two closed triangles have in common: the first one clipped by the plane and sides of the second."""
    up = normal(second)
    polygon = clipped(clipped(first, second[0], up), second[0], minus((0, 0, 0), up))
    for k in range(3):
        a, b = second[k], second[(k + 1) % 3]
        polygon = clipped(polygon, a, cross(up, minus(b, a)))
    return polygon


def clipped(polygon, origin, inward):
    heights = [dot(minus(p, origin), inward) for p in polygon]
    kept = []
    for k, (p, height) in enumerate(zip(polygon, heights, strict=True)):
        q, other = polygon[(k + 1) % len(polygon)], heights[(k + 1) % len(polygon)]
        if height >= 0:
            kept.append(p)
        if height * other < 0:
            share = height / (height - other)
            kept.append(tuple(a + share * (b - a) for a, b in zip(p, q, strict=True)))
    return kept


def inside(point, triangle):
    """Whether a point of its plane lies inside a triangle, off its rim."""
    up = normal(triangle)
    return all(
        dot(cross(up, minus(triangle[(k + 1) % 3], triangle[k])), minus(point, triangle[k])) > 0 for k in range(3)
    )


def spanned(point, corners):
    """Whether a point is the corner, or lies between the two corners."""
    if len(corners) == 1:
        return point == corners[0]
    if len(corners) == 2:
        along, there = minus(corners[1], corners[0]), minus(point, corners[0])
        return not any(cross(along, there)) and 0 <= dot(along, there) <= dot(along, along)
    return False


def facing(first, second):
    """Whether two triangles of one plane look towards opposite sides."""
    return dot(normal(first), normal(second)) < 0


def normal(triangle):
    return cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b, strict=True))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a, b):
    return tuple(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3))
