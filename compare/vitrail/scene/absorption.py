"""What the inside of a material takes from light, as coefficients of Beer and Lambert's law."""

from __future__ import annotations

import math

from vitrail.scene.model import Material


def absorption_per_m(material: Material) -> tuple[float, float, float]:
    """Coefficients, 1/m: the given ones, or -ln(color) / distance; (0, 0, 0) without absorption."""
    if material.absorption_per_m is not None:
        return material.absorption_per_m
    if material.attenuation is None:
        return (0.0, 0.0, 0.0)
    color, distance = material.attenuation.color, material.attenuation.distance
    return (-math.log(color[0]) / distance, -math.log(color[1]) / distance, -math.log(color[2]) / distance)
