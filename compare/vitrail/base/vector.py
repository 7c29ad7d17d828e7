"""Arithmetic of points and directions as plain triples of floats.

Every function scales exactly with powers of two: multiplying all lengths of a scene by 2^k multiplies every length
computed here by 2^k to the last bit, which the scale test of the tracer relies on [O part 2].
"""

from __future__ import annotations

import math

Vec = tuple[float, float, float]


def add(a: Vec, b: Vec) -> Vec:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vec, b: Vec) -> Vec:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a: Vec, factor: float) -> Vec:
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a: Vec, b: Vec) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vec, b: Vec) -> Vec:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a: Vec) -> float:
    """Euclidean length; free of overflow and underflow of the squares."""
    return math.hypot(*a)


def unit(a: Vec) -> Vec:
    """``a`` at length 1; a direction along an axis comes out exactly."""
    size = length(a)
    if size == 0:
        raise ValueError("the zero vector has no direction")
    return (a[0] / size, a[1] / size, a[2] / size)
