"""Lamps in the middle of glass stand a hair beside it in POV-Ray.

POV-Ray spaces the photons of a lamp by its distance from the middle of the box around a target, also from inside the
target; a lamp in the middle itself shoots five photons, whatever the spacing [P 2.1]. Such a lamp moves by a hair, and
in the second half image by the same hair to the other side, so that what changes evenly with its place cancels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vitrail.base.vector import Vec, add, length, scale, subtract
from vitrail.lower.povray.photons.photons import Ball
from vitrail.lower.povray.text.lights import Source

HAIR = 1 / 1024
"""How near the middle of a target a lamp may stand, and where it stands instead; shares of the target's radius."""
ASIDE: Vec = (0.48, 0.6, 0.64)
"""Where it moves: along no axis, edge or diagonal that a scene is likely to have."""


def off_centre(sources: Sequence[Source], balls: Sequence[Ball], is_mirrored: bool) -> tuple[Source, ...]:
    """The lights, those in the middle of a target beside it; ``is_mirrored`` for the second half image."""
    return tuple(_beside(source, balls, -1.0 if is_mirrored else 1.0) for source in sources)


def _beside(source: Source, balls: Sequence[Ball], side: float) -> Source:
    """One light; of targets that share their middle the largest decides."""
    if source.direction is not None:
        return source
    near = [ball for ball in balls if length(subtract(source.position, ball.centre)) < HAIR * ball.radius]
    if not near:
        return source
    ball = max(near, key=lambda each: each.radius)
    place = add(ball.centre, scale(ASIDE, side * HAIR * ball.radius))
    return replace(source, position=place, aside=length(subtract(place, source.position)))
