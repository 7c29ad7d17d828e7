"""How many samples a pixel needs, so that a caustic is seen as fine as it is gathered.

The light of a photon map varies over one gather radius. Samples that are farther apart than that on the receiver meet a
bright spot by chance, and an engine with a fixed grid of samples meets it, or misses it, the same way each time: its
halves then agree with each other and with nobody else.
"""

from __future__ import annotations

import math

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.vector import cross, dot, subtract, unit
from vitrail.geometry.camera import sight
from vitrail.scene.model import Patch, Scene

SPACING = 1.5
"""Gather radii between two samples at most: the disc of every photon, two radii wide, then holds one."""

MOST = 32
"""Samples a pixel at most; a spot that asks for more is smaller than a picture of this size can show."""


def samples_for(scene: Scene, gather_radius_m: float) -> int:
    """The least number of samples a pixel that resolves every observed caustic, at most ``MOST``; 1 without any."""
    areas = [pixel_area_m2(scene, item.patch) for item in scene.observe if item.phenomenon is Phenomenon.CAUSTIC]
    wanted = max((area / (SPACING * gather_radius_m) ** 2 for area in areas), default=1.0)
    return max(1, min(math.ceil(wanted), MOST))


def pixel_area_m2(scene: Scene, patch: Patch) -> float:
    """What a pixel covers on the plane of a patch, around its centre."""
    camera, image = scene.camera, scene.image
    depth = sight(camera, image, patch.center).depth_m
    if camera.kind == "orthographic":
        edge, view = (camera.height or 0.0) / image.height, subtract(camera.look_at, camera.position)
    else:
        edge = 2 * depth * math.tan(math.radians(camera.fov_deg or 0.0) / 2) / image.height
        view = subtract(patch.center, camera.position)
    cosine = abs(dot(unit(view), unit(cross(patch.u, patch.v))))
    return edge**2 / max(cosine, 0.05)
