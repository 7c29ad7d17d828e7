"""Deviation by prisms and by drops."""

from __future__ import annotations

from mpmath import acos, asin, cos, degrees, diff, findroot, mpf, radians, sin, sqrt


def deviation_deg(index, apex_deg, incidence_deg):
    """By a prism in air, through two faces; complex beyond total reflection."""
    first, apex = radians(mpf(incidence_deg)), radians(mpf(apex_deg))
    inner = apex - asin(sin(first) / index)
    return degrees(first + asin(index * sin(inner)) - apex)


def least_deviation_deg(index, apex_deg):
    """Symmetric passage: n sin(A / 2) = sin((A + D) / 2)."""
    half = radians(mpf(apex_deg)) / 2
    return degrees(2 * asin(index * sin(half))) - apex_deg


def least_deviation_by_search_deg(index, apex_deg):
    """The same by finding the incidence where the deviation stands still."""
    start = degrees(asin(index * sin(radians(mpf(apex_deg)) / 2))) + 1
    found = findroot(lambda incidence: diff(lambda x: deviation_deg(index, apex_deg, x), incidence), start)
    return deviation_deg(index, apex_deg, found)


def screen_height(index, apex_deg, incidence_deg, screen, aside=0):
    """Where a ray of a beam through a prism of side 1 meets the screen x = ``screen``; the centroid is 0, 0.

    The ray meets the left face at ``incidence_deg``, going upwards, ``aside`` from its middle towards the apex; it is
    followed as a line in x, y.
    """
    half = radians(mpf(apex_deg)) / 2
    base, rise = sin(half), cos(half)
    # Where the left face is met, and directions as angles from +x: the face's inward normal points down by half.
    x, y = -base / 2 + aside * base, -rise / 3 + rise / 2 + aside * rise
    inside = -half + asin(sin(radians(mpf(incidence_deg))) / index)
    # The right face runs from the apex (0, 2 rise / 3) down to (base, -rise / 3); its outward normal points up by half.
    step = (rise * x + base * (y - 2 * rise / 3)) / -(rise * cos(inside) + base * sin(inside))
    x, y = x + step * cos(inside), y + step * sin(inside)
    # The angle from the normal, positive upwards; both faces turn the ray towards the base.
    outside = half + asin(index * sin(inside - half))
    return y + (screen - x) * sin(outside) / cos(outside)


def rainbow_deg(index, bounces):
    """Angle of the bow of a drop from the point opposite to the sun, after ``bounces`` reflections inside.

    The deviation 2 (i - r) + k (180 - 2 r) stands still at cos i = sqrt((n^2 - 1) / (k (k + 2))).
    """
    n = mpf(index)
    i = acos(sqrt((n * n - 1) / (bounces * (bounces + 2))))
    r = asin(sin(i) / n)
    turned = degrees(2 * (i - r)) + bounces * (180 - 2 * degrees(r))
    return abs(180 - turned % 360)
