"""Deviation by prisms and by drops."""

from __future__ import annotations

from mpmath import acos, asin, degrees, diff, findroot, mpf, radians, sin, sqrt


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


def rainbow_deg(index, bounces):
    """Angle of the bow of a drop from the point opposite to the sun, after ``bounces`` reflections inside.

    The deviation 2 (i - r) + k (180 - 2 r) stands still at cos i = sqrt((n^2 - 1) / (k (k + 2))).
    """
    n = mpf(index)
    i = acos(sqrt((n * n - 1) / (bounces * (bounces + 2))))
    r = asin(sin(i) / n)
    turned = degrees(2 * (i - r)) + bounces * (180 - 2 * degrees(r))
    return abs(180 - turned % 360)
