"""What a renderer must show of the conformance scenes: floors under two lights, and panels that glow."""

from __future__ import annotations

from itertools import product

from mpmath import atan, mpf, pi, sqrt


def seen_solid_angle(height, left, right, near, far):
    """Solid angle of a rectangle in the floor as seen from ``height`` above the origin, from its corners.

    That of [0, x] x [0, z] is atan(x z / (h sqrt(x^2 + z^2 + h^2))), odd in x and in z.
    """
    h = mpf(height)

    def corner(x, z):
        return atan(x * z / (h * sqrt(x * x + z * z + h * h)))

    return sum(
        (1 if a == right else -1) * (1 if b == far else -1) * corner(a, b)
        for a, b in product((left, right), (near, far))
    )


def floor_under_sun_and_lamp(x, z, half_edge):
    """Mean radiance of a square patch of ``units.yaml``: d / pi (E cos + I times the solid angle, by area)."""
    away_x, away_z, a = mpf(x) - mpf("0.7"), mpf(z) - mpf("0.4"), mpf(half_edge)
    solid_angle = seen_solid_angle("0.5", away_x - a, away_x + a, away_z - a, away_z + a)
    return mpf("0.5") / pi * (2 * mpf("0.6") + mpf("0.4") * solid_angle / (4 * a * a))


GLOWING = {
    "step_1": ("0.002",) * 3,
    "step_2": ("0.04",) * 3,
    "step_3": ("0.8",) * 3,
    "step_4": ("16",) * 3,
    "step_5": ("320",) * 3,
    "red": ("1", "0", "0"),
    "green": ("0", "1", "0"),
    "blue": ("0", "0", "1"),
}
"""Emission of the panels of ``colour.yaml``."""


def card_in_coloured_light(channel):
    """Radiance d E / pi of the card of ``colour.yaml``, which faces its sun."""
    diffuse, irradiance = ("0.8", "0.4", "0.2"), ("1", "2", "4")
    return mpf(diffuse[channel]) * mpf(irradiance[channel]) / pi
