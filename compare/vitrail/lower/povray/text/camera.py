"""The camera by explicit vectors, so that pixel (i + 1/2, j + 1/2) looks exactly where the scene says.

POV-Ray sends pixel (x, y) of a W x H image along direction + (x / W - 1/2) right + (1/2 - y / H) up, with the vectors
as given: nothing is turned or mirrored while ``look_at``, ``angle`` and ``sky`` stay unused [M]. Coordinates therefore
keep their handedness, and only ``right`` says that the picture is seen by a right-handed eye.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.base.vector import Vec, add, cross, scale, subtract, unit
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.text.sdl import Block, block, statement, vector
from vitrail.scene.model import Camera, Image


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


def camera_sdl(
    camera: Camera, image: Image, samples_across: int, shift: SubpixelShift, normalisation: Normalisation
) -> Block:
    """The camera of an image rendered ``samples_across`` times as wide and high as the scene's."""
    forward = unit(subtract(camera.look_at, camera.position))
    right = unit(cross(forward, camera.up))
    up = cross(right, forward)
    half_height = _half_height(camera, normalisation)
    half_width = half_height * (image.width / image.height)
    across, rise = scale(right, 2 * half_width), scale(up, 2 * half_height)
    offset = add(
        scale(across, shift.right / (image.width * samples_across)),
        scale(rise, shift.up / (image.height * samples_across)),
    )
    location, direction = _shifted(camera, normalisation.point(camera.position), forward, offset)
    return block(
        "camera",
        statement(camera.kind),
        statement("location", vector(location)),
        statement("direction", vector(direction)),
        statement("right", vector(across)),
        statement("up", vector(rise)),
    )


def _half_height(camera: Camera, normalisation: Normalisation) -> float:
    """Tangent of half the field of view, or half the height in units."""
    if camera.kind == "perspective":
        assert camera.fov_deg is not None
        return math.tan(math.radians(camera.fov_deg) / 2)
    assert camera.height is not None
    return normalisation.length(camera.height) / 2


def _shifted(camera: Camera, location: Vec, forward: Vec, offset: Vec) -> tuple[Vec, Vec]:
    """Turn a perspective camera's rays, move an orthographic camera's."""
    if camera.kind == "perspective":
        return location, add(forward, offset)
    return add(location, offset), forward
