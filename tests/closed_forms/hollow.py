"""Rays through balls, shells and bubbles: what is round keeps n sin(angle) times the distance from the centre."""

from __future__ import annotations

from mpmath import asin, mpf, sin


def ball_turn(b, index):
    """How far a ball of radius 1 turns a ray that passes its centre at ``b``, radians, towards the axis."""
    return 2 * (asin(mpf(b)) - asin(mpf(b) / index))


def shell_turn(b, index, inner):
    """The same for a shell of outer radius 1 around air of radius ``inner`` > ``b``; negative: away from the axis."""
    outer_face = asin(mpf(b)) - asin(mpf(b) / index)
    inner_face = asin(mpf(b) / (index * inner)) - asin(mpf(b) / inner)
    return 2 * (outer_face + inner_face)


def shell_crossing(b, index, inner):
    """Where the ray behind the shell meets the axis, from the centre: it leaves as far from it as it came."""
    return mpf(b) / sin(shell_turn(b, index, inner))


def shell_focus(index, inner):
    """The limit of that for rays near the axis: n / (2 (n - 1)) / (1 - 1 / inner), positive behind the centre."""
    n = mpf(index)
    return n / (2 * (n - 1)) / (1 - 1 / mpf(inner))


def bubble_turn(b, index, radius):
    """How far a bubble of air in glass turns a ray at ``b`` < radius / index; farther out it mirrors everything."""
    return 2 * (asin(mpf(b) / radius) - asin(index * mpf(b) / radius))


def bubble_mirror_turn(b, radius):
    """Total reflection on the outside of the bubble: the angle between the ray and its mirror image."""
    return 2 * (asin(1) - asin(mpf(b) / radius))
