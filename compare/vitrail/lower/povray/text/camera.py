"""The camera by explicit vectors, so that pixel (i + 1/2, j + 1/2) looks exactly where the scene says.

POV-Ray sends pixel (x, y) of a W x H image along direction + (x / W - 1/2) right + (1/2 - y / H) up, with the vectors
as given: nothing is turned or mirrored while ``look_at``, ``angle`` and ``sky`` stay unused [M]. Coordinates therefore
keep their handedness, and only ``right`` says that the picture is seen by a right-handed eye.
"""

from __future__ import annotations

from vitrail.base.vector import scale
from vitrail.geometry.camera import View
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.text.sdl import Block, block, statement, vector


def camera_sdl(view: View, units: Normalisation) -> Block:
    """The camera of the scene's picture, of whatever number of pixels."""
    half_height = view.half_height if view.perspective else units.length(2 * view.half_height) / 2
    half_width = half_height * (view.width / view.height)
    across, rise = scale(view.right, 2 * half_width), scale(view.up, 2 * half_height)
    return block(
        "camera",
        statement("perspective" if view.perspective else "orthographic"),
        statement("location", vector(units.point(view.position))),
        statement("direction", vector(view.forward)),
        statement("right", vector(across)),
        statement("up", vector(rise)),
    )
