"""Light left after absorbing matter, by Beer and Lambert [O 2.36]."""

from __future__ import annotations

from mpmath import exp, mpf, quad


def slab_left(absorption_per_m, thickness):
    return exp(-mpf(absorption_per_m) * thickness)


def wedge_mean(absorption_per_m, slope, start, stop):
    """Mean of exp(-a slope x) for x from ``start`` to ``stop``."""
    rate = mpf(absorption_per_m) * slope
    return (exp(-rate * start) - exp(-rate * stop)) / (rate * (mpf(stop) - start))


def wedge_mean_by_quadrature(absorption_per_m, slope, start, stop):
    return quad(lambda x: slab_left(absorption_per_m, slope * x), [start, stop]) / (mpf(stop) - start)
