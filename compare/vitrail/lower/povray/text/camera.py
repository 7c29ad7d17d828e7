"""The camera by explicit vectors, so that pixel (i + 1/2, j + 1/2) looks exactly where the scene says.

POV-Ray sends pixel (x, y) of a W x H image along direction + (x / W - 1/2) right + (1/2 - y / H) up, with the vectors
as given: nothing is turned or mirrored while ``look_at``, ``angle`` and ``sky`` stay unused [M]. Coordinates therefore
keep their handedness, and only ``right`` says that the picture is seen by a right-handed eye.
"""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.base.vector import add, scale
from vitrail.geometry.camera import View
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.text.sdl import Block, block, statement, vector


@dataclass(frozen=True)
class SubpixelShift:
    """An offset of every sample, in samples: right and up."""

    right: float
    up: float


CENTRED = SubpixelShift(0.0, 0.0)
HALF_SHIFTS = {"a": CENTRED, "b": CENTRED}
"""Both half images sample a pixel at the same places: their difference is the noise of photons and lamps alone.

Opposite shifts would make every gradient look like noise that cancels in the mean, fifty times too much on a caustic.
"""


def camera_sdl(view: View, samples_across: int, shift: SubpixelShift, units: Normalisation) -> Block:
    """The camera of an image rendered ``samples_across`` times as wide and high as the scene's."""
    half_height = view.half_height if view.perspective else units.length(2 * view.half_height) / 2
    half_width = half_height * (view.width / view.height)
    across, rise = scale(view.right, 2 * half_width), scale(view.up, 2 * half_height)
    offset = add(
        scale(across, shift.right / (view.width * samples_across)),
        scale(rise, shift.up / (view.height * samples_across)),
    )
    location, direction = units.point(view.position), view.forward
    # Turn a perspective camera's rays, move an orthographic camera's.
    if view.perspective:
        direction = add(direction, offset)
    else:
        location = add(location, offset)
    return block(
        "camera",
        statement("perspective" if view.perspective else "orthographic"),
        statement("location", vector(location)),
        statement("direction", vector(direction)),
        statement("right", vector(across)),
        statement("up", vector(rise)),
    )
