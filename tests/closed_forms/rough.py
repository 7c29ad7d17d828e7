"""The deflection that equation 8 gives, from its definition and in closed form [S eq. 8] [O 1.3]."""

from __future__ import annotations

from mpmath import acos, atan, atanh, degrees, findroot, log, mpf, pi, quad, sqrt


def below(x, roughness):
    """The share of rays whose tangent of deflection is at most ``x``, in closed form."""
    q = mpf(roughness) / (2 - mpf(roughness))
    if x >= q:
        return mpf(1)
    if x <= 0:
        return mpf(0)
    inner = sqrt((1 - x) * (q - x) / ((1 + x) * (q + x)))
    return 1 - 2 / mpf(roughness) * (
        sqrt(q * q - x * x) / (1 + q) - x * acos(x / q) + 2 * x * x / sqrt(1 - x * x) * atanh(inner)
    )


def below_by_quadrature(x, roughness):
    """The same share from the definition: tan = s g / (1 - g), g uniform on [0, roughness / 2], s the distance of a
    random unit vector from the axis, P(s <= y) = 1 - sqrt(1 - y^2)."""
    half = mpf(roughness) / 2

    def share(g):
        y = x * (1 - g) / g
        return mpf(1) if y >= 1 else 1 - sqrt(1 - y * y)

    # Below g = x / (1 + x) every s counts.
    start = min(mpf(x) / (1 + x), half)
    return (start + (quad(share, [start, half]) if start < half else 0)) / half


def mean_tangent(roughness):
    half = mpf(roughness) / 2
    return pi / 4 / half * (-log(1 - half) - half)


def mean_square_tangent(roughness):
    half = mpf(roughness) / 2
    return mpf(2) / 3 / half * (1 / (1 - half) - 1 + 2 * log(1 - half) + half)


def mean_square_tangent_by_quadrature(roughness):
    """The mean of x^2 is the integral of 2 x (1 - F(x))."""
    q = mpf(roughness) / (2 - mpf(roughness))
    return quad(lambda x: 2 * x * (1 - below(x, roughness)), [0, q])


def quantile_deg(share, roughness):
    """The angle that ``share`` of the rays does not exceed."""
    q = mpf(roughness) / (2 - mpf(roughness))
    return degrees(
        atan(findroot(lambda x: below(x, roughness) - share, [q / 1000, q * mpf("0.999")], solver="anderson"))
    )
