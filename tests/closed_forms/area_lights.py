"""Irradiance and penumbra of lamps with a size."""

from __future__ import annotations

from mpmath import atan, cos, mpf, pi, quad, sqrt


def disc_irradiance(radiance, radius, distance):
    """On the axis of a facing Lambertian disc: pi L R^2 / (R^2 + h^2)."""
    return pi * radiance * mpf(radius) ** 2 / (mpf(radius) ** 2 + mpf(distance) ** 2)


def disc_irradiance_by_quadrature(radiance, radius, distance):
    h = mpf(distance)
    return quad(lambda r: radiance * 2 * pi * r * h * h / (r * r + h * h) ** 2, [0, radius])


def disc_irradiance_aside(radiance, radius, distance, aside):
    """The same ``aside`` from the axis (Howell, configuration B-13)."""
    r, h, a = mpf(radius), mpf(distance), mpf(aside)
    square = a * a + h * h
    return pi * radiance / 2 * (1 - (square - r * r) / sqrt((square + r * r) ** 2 - 4 * r * r * a * a))


def disc_irradiance_aside_by_quadrature(radiance, radius, distance, aside):
    h, a = mpf(distance), mpf(aside)
    return quad(
        lambda r, t: radiance * r * h * h / (r * r - 2 * r * a * cos(t) + a * a + h * h) ** 2, [0, radius], [0, 2 * pi]
    )


def disc_irradiance_over_patch(radiance, radius, distance, half_edge):
    """Mean over a small square about the axis."""
    a = mpf(half_edge)
    whole = quad(lambda x, z: disc_irradiance_aside(radiance, radius, distance, sqrt(x * x + z * z)), [0, a], [0, a])
    return whole / (a * a)


def rectangle_irradiance(radiance, half_u, half_v, distance):
    """Below the centre of a facing Lambertian rectangle: four times the corner form factor (Howell B-3)."""
    x, y = mpf(half_u) / distance, mpf(half_v) / distance
    p, q = sqrt(1 + x * x), sqrt(1 + y * y)
    corner = (x / p * atan(y / p) + y / q * atan(x / q)) / (2 * pi)
    return 4 * pi * radiance * corner


def rectangle_irradiance_by_quadrature(radiance, half_u, half_v, distance):
    h = mpf(distance)
    return quad(lambda x, y: radiance * h * h / (x * x + y * y + h * h) ** 2, [-half_u, half_u], [-half_v, half_v])


def straight_penumbra_width(lamp_half_width, lamp_to_edge, edge_to_screen):
    """10 to 90 % behind a straight edge parallel to a square lamp far wider than it is off axis: 0.8 of the image of
    the lamp's width through the edge, 2 w z / D."""
    return mpf("0.8") * 2 * lamp_half_width * edge_to_screen / lamp_to_edge
