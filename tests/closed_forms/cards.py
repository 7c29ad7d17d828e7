"""Diffuse cards under a sun and under a lamp."""

from __future__ import annotations

from mpmath import atan, cos, mpf, pi, quad, sin, sqrt


def sunlit(diffuse, irradiance, cosine):
    """Radiance d E cos / pi of a card under a directional light."""
    return mpf(diffuse) * irradiance * cosine / pi


def lamplit_mean(diffuse, intensity, height, half_edge):
    """Mean radiance of a square patch under a point light above its centre.

    The flux on it is the intensity times the patch's solid angle 4 atan(a^2 / (h sqrt(2 a^2 + h^2))).
    """
    a, h = mpf(half_edge), mpf(height)
    solid_angle = 4 * atan(a * a / (h * sqrt(2 * a * a + h * h)))
    return mpf(diffuse) / pi * intensity * solid_angle / (4 * a * a)


def lamplit_mean_by_quadrature(diffuse, intensity, height, half_edge):
    """The same mean by integrating I h / d^3 over the patch."""
    a, h = mpf(half_edge), mpf(height)
    flux = quad(lambda x, z: intensity * h / sqrt(x * x + h * h + z * z) ** 3, [-a, a], [-a, a])
    return mpf(diffuse) / pi * flux / (4 * a * a)


def lamplit_bow(height, half_edge):
    """Bow of the best parabola over the patch (``diffusion.evenness``): 1, s, t, s^2 + t^2 with s, t in [-1, 1].

    By symmetry the fit is one line in q = s^2 + t^2, whose mean is 2/3 and whose variance is 2 * 4/45; twice its slope
    over the mean radiance is middle minus border.
    """
    a, h = mpf(half_edge), mpf(height)

    def moment(s, t):
        return h / sqrt((a * s) ** 2 + h * h + (a * t) ** 2) ** 3 * (s * s + t * t - mpf(2) / 3)

    # One quadrant is a quarter of the whole.
    slope = quad(moment, [0, 1], [0, 1]) / (mpf(8) / 45)
    return -2 * slope / lamplit_mean(pi, 1, height, half_edge)


def half_and_half(share, bright, dim):
    """Mean radiance of a mirror that shows two walls, half of the patch each."""
    return mpf(share) * (mpf(bright) + dim) / 2


def overcast_row(row, *, rows):
    """Mean over one row of an image of the overcast sky, by solid angle; row 0 is up."""
    top, bottom = pi / 2 - pi * row / rows, pi / 2 - pi * (row + 1) / rows
    power = quad(lambda g: (1 + 2 * sin(g)) / 3 * cos(g), [bottom, top])
    return power / quad(cos, [bottom, top])


def overcast_irradiance(*, rows):
    """Of a level face under that image, W m^-2 for a zenith of 1; 7 pi / 9 for very fine rows."""
    total = mpf(0)
    for row in range(rows // 2):
        top, bottom = pi / 2 - pi * row / rows, pi / 2 - pi * (row + 1) / rows
        total += overcast_row(row, rows=rows) * quad(lambda g: 2 * pi * sin(g) * cos(g), [bottom, top])
    return total
