"""Light left after absorbing matter, by Beer and Lambert [O 2.36]."""

from __future__ import annotations

from mpmath import exp, mpf, quad, sqrt


def slab_left(absorption_per_m, thickness):
    return exp(-mpf(absorption_per_m) * thickness)


def wedge_mean(absorption_per_m, slope, start, stop):
    """Mean of exp(-a slope x) for x from ``start`` to ``stop``."""
    rate = mpf(absorption_per_m) * slope
    return (exp(-rate * start) - exp(-rate * stop)) / (rate * (mpf(stop) - start))


def wedge_mean_by_quadrature(absorption_per_m, slope, start, stop):
    return quad(lambda x: slab_left(absorption_per_m, slope * x), [start, stop]) / (mpf(stop) - start)


def absorbing_film(indices, absorption_per_m, thickness):
    """Light that an absorbing layer between two media passes at normal incidence, with every bounce inside it."""
    above, inside, below = map(mpf, indices)
    upper, lower = ((above - inside) / (above + inside)) ** 2, ((inside - below) / (inside + below)) ** 2
    left = slab_left(absorption_per_m, thickness)
    return (1 - upper) * (1 - lower) * left / (1 - upper * lower * left**2)


def absorbing_film_way_by_way(indices, absorption_per_m, thickness, ways=12):
    """The same as a sum over light that crosses the layer once, three times and so on."""
    above, inside, below = map(mpf, indices)
    upper, lower = ((above - inside) / (above + inside)) ** 2, ((inside - below) / (inside + below)) ** 2
    crossed = [slab_left(absorption_per_m, (2 * k + 1) * mpf(thickness)) * (upper * lower) ** k for k in range(ways)]
    return (1 - upper) * (1 - lower) * sum(crossed)


def torus_mean(absorption_per_m, radii, half):
    """Mean through a torus seen along its axis, over a rectangle with half edges ``half`` about its tube."""
    ring, tube = map(mpf, radii)
    across, along = map(mpf, half)

    def left(x, z):
        return slab_left(absorption_per_m, 2 * sqrt(tube**2 - (sqrt(x * x + z * z) - ring) ** 2))

    return quad(left, [ring - across, ring, ring + across], [0, along]) / (2 * across * along)
