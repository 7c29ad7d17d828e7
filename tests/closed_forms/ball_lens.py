"""The caustic of a ball lens under a vertical sun, by the map from where a ray enters to where it lands [O 1.6]."""

from __future__ import annotations

from mpmath import asin, cos, diff, findroot, mpf, pi, quad, sin


def landing(b, index, drop):
    """Signed distance from the axis at which a ray, ``b`` from the axis of a unit ball, meets a plane ``drop`` below.

    sin i = b, sin r = b / index; the ray leaves the ball at x = sin(2r - i), y = -cos(2r - i), turned by 2 (i - r).
    """
    i, r = asin(b), asin(b / index)
    turn = 2 * (i - r)
    return sin(2 * r - i) - (drop - cos(2 * r - i)) * sin(turn) / cos(turn)


def entry(rho, index, drop):
    """The distance from the axis at which light that lands at ``rho`` entered: the inverse of ``-landing``.

    For a plane beyond every focus the map is monotone, so there is one.
    """
    paraxial = mpf(rho) / (drop * 2 * (index - 1) / index - 1)
    return findroot(lambda b: -landing(b, index, drop) - rho, min(paraxial, mpf("0.7")))


def irradiance_gain(rho, index, drop):
    """Irradiance over that of the sun at ``rho``: the Jacobian (b / rho) / |d rho / d b| of the map."""
    b = entry(rho, index, drop)
    return b / rho / abs(diff(lambda x: landing(x, index, drop), b))


def flux_within(rho, index, drop):
    """Flux over the sun's irradiance inside a circle: all that enters inside ``b(rho)``, so pi b^2, m^2."""
    return pi * entry(rho, index, drop) ** 2


def ring_gain(inner, outer, index, drop):
    """Mean irradiance over that of the sun between two radii."""
    low = flux_within(inner, index, drop) if inner > 0 else mpf(0)
    return (flux_within(outer, index, drop) - low) / (pi * (mpf(outer) ** 2 - mpf(inner) ** 2))


def radius_of_share(share, outer, index, drop):
    """The radius that holds ``share`` of the flux inside ``outer``: there b^2 is that share of b(outer)^2."""
    return -landing(entry(outer, index, drop) * mpf(share) ** mpf("0.5"), index, drop)


def flux_by_quadrature(outer, index, drop):
    """The same flux as ``flux_within`` by integrating the Jacobian over the plane: an independent check."""
    return quad(lambda rho: 2 * pi * rho * irradiance_gain(rho, index, drop), [mpf("1e-12"), outer])
