"""A colour as three numbers: linear Rec. 709 red, green and blue, of light or as a share of it."""

from __future__ import annotations

Triplet = tuple[float, float, float]


def times(colour: Triplet, factor: float) -> Triplet:
    """A colour with every channel multiplied."""
    return (colour[0] * factor, colour[1] * factor, colour[2] * factor)
