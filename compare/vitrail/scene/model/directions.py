"""Vecs that give a direction, an axis or a frame: refused where they give none."""

from __future__ import annotations

from vitrail.base.fault import Fault
from vitrail.base.vector import Vec, dot, length


def refuse_zero(vector: Vec, key: str) -> None:
    if length(vector) == 0:
        raise Fault(f"`{key}` is the zero vector and has no direction", "give it a length")


def refuse_same(a: Vec, b: Vec) -> None:
    if a == b:
        raise Fault("`from` and `to` are the same point", "move one of them")


def refuse_slant(u: Vec, v: Vec) -> None:
    cosine = dot(u, v) / (length(u) * length(v))
    if abs(cosine) > 1e-9:
        raise Fault(f"`u` and `v` are not perpendicular (cosine {cosine:.3g})", "turn one of them")
