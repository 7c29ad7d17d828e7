"""How many samples a pixel needs, so that a caustic is seen as fine as it is gathered.

The light of a photon map varies over one gather radius. Samples that are farther apart than that on the receiver meet a
bright spot by chance, and an engine with a fixed grid of samples meets it, or misses it, the same way each time: its
halves then agree with each other and with nobody else.
"""

from __future__ import annotations

import math

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.vector import cross, dot, unit
from vitrail.geometry.camera import View
from vitrail.geometry.world import World
from vitrail.scene.model import Patch

SPACING = 1.5
"""Gather radii between two samples at most: the disc of every photon, two radii wide, then holds one."""

MOST = 32
"""Samples a pixel at most; a spot that asks for more is smaller than a picture of this size can show."""


def samples_for(world: World, gather_radius_m: float) -> int:
    """The least number of samples a pixel that resolves every observed caustic, at most ``MOST``; 1 without any."""
    patches = [item.patch for item in world.scene.observe if item.phenomenon is Phenomenon.CAUSTIC]
    return max((samples_to_see(world.view, patch, gather_radius_m) for patch in patches), default=1)


def samples_to_see(view: View, patch: Patch, gather_radius_m: float) -> int:
    """The least number of samples a pixel that resolves the caustic on a patch, at most ``MOST``."""
    wanted = pixel_area_m2(view, patch) / (SPACING * gather_radius_m) ** 2
    return max(1, min(math.ceil(wanted), MOST))


def pixel_area_m2(view: View, patch: Patch) -> float:
    """What a pixel covers on the plane of a patch, around its centre."""
    edge = view.pixel_size_m(patch.center)
    cosine = abs(dot(view.sight_line(patch.center), unit(cross(patch.u, patch.v))))
    return edge**2 / max(cosine, 0.05)
