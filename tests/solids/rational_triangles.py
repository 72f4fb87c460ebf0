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
    """Corners of what two closed triangles have in common: the first clipped by plane and sides of the second."""
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


def passings(vertices, triangles):
    """Pairs that pass through each other, and pairs that only touch: of `meetings`, those that look at each other from
    both sides of one plane touch, unless folded at an edge of their own; and an edge with triangles on both sides of
    another that it lies in passes through it."""
    points = [tuple(Fraction(float(x)) for x in vertex) for vertex in vertices]
    corners = [[points[i] for i in triangle] for triangle in triangles]
    sides = [[frozenset((triangle[k], triangle[(k + 1) % 3])) for k in range(3)] for triangle in triangles]
    through, touching = meetings(vertices, triangles)
    for s, t in list(through):
        in_plane = all(dot(minus(p, corners[t][0]), normal(corners[t])) == 0 for p in corners[s])
        common = set(sides[s]) & set(sides[t])
        folded = any(sum(edge in of for of in sides) == 2 for edge in common)
        if in_plane and dot(normal(corners[s]), normal(corners[t])) < 0 and not folded:
            through.remove((s, t))
            touching.add((s, t))
    along = {}
    for s, t in touching:
        for one, other in ((s, t), (t, s)):
            heights = [dot(minus(p, corners[other][0]), normal(corners[other])) for p in corners[one]]
            common = intersection(corners[one], corners[other])
            middle = tuple(sum(p[k] for p in common) / len(common) for k in range(3))
            if heights.count(0) == 2 and len(set(common)) > 1 and inside(middle, corners[other]):
                edge = frozenset(i for i, height in zip(triangles[one], heights, strict=True) if height == 0)
                along.setdefault((edge, other), set()).add((sum(heights) > 0, (s, t)))
    for found in along.values():
        if {above for above, _ in found} == {True, False}:
            through |= {pair for _, pair in found}
    return through, touching - through


def normal(triangle):
    return cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b, strict=True))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a, b):
    return tuple(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3))
