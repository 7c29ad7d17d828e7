"""Observations must be seen: their patches lie on a surface, in front of the camera and inside its picture."""

from __future__ import annotations

import math

import numpy as np

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.suggestion import suggestion
from vitrail.base.vector import cross, dot, length, unit
from vitrail.check.findings import Findings
from vitrail.geometry.camera import Sighting, View
from vitrail.geometry.patch import corners_of
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.scene.model import Observation, Patch

OFF_SURFACE = 1e-6
"""A patch farther from every surface than this share of its size is reported as lying on none."""

CURVED = 0.06
"""On a curved surface the corners of a patch may stand off by this share of its half edges."""

FACING = 0.02
"""Below this cosine (89 degrees) a patch is too foreshortened to be measured."""

LEAST_PIXELS = 0.25
"""A patch that is narrower in the picture shows its neighbours and not itself."""

_STEPS = 1024

THROUGH_GLASS = {
    Phenomenon.REFRACTION,
    Phenomenon.TOTAL_INTERNAL_REFLECTION,
    Phenomenon.COLOURED_TRANSMISSION,
    Phenomenon.ABSORPTION,
    Phenomenon.ROUGHNESS,
    Phenomenon.DISPERSION,
    Phenomenon.REFLECTION,
}
"""Phenomena that may be measured through glass; the others are wanted unbent, straight from the patch."""


def check_views(findings: Findings) -> None:
    """Check where the camera stands and that it sees every observed patch."""
    world = findings.world_without_meshes
    for index, (item, solid) in enumerate(zip(world.scene.objects, world.solids, strict=True)):
        opaque = solid.is_closed and not world.material(index).is_transmissive
        if opaque and solid.contains(world.scene.camera.position) and not world.is_room(index):
            what = f"the camera is inside the opaque `{item.name}`"
            findings.error(what, "move `position` out of it", "camera", "position")
    for index, observation in enumerate(world.scene.observe):
        _check_keys(findings, index, observation)
        if _check_in_picture(findings, world.view, index, observation.patch):
            _check_facing(findings, world.view, index, observation.patch)
            _check_on_surface(findings, world, index, observation.patch)
            _check_unhidden(findings, world, index, observation)


def _check_keys(findings: Findings, index: int, observation: Observation) -> None:
    """What a phenomenon needs beside its patch."""
    if observation.phenomenon is Phenomenon.DISPERSION and observation.along is None:
        what = f"`{observation.name}` does not say along which edge the colours spread"
        findings.error(what, "add `along: u` or `along: v`", "observe", index)
    names = [item.name for item in findings.scene.objects]
    if observation.pattern is not None and observation.pattern not in names:
        what = f"there is no object `{observation.pattern}` to be the pattern"
        findings.error(what, suggestion(observation.pattern, names, "object"), "observe", index, "pattern")


def _check_in_picture(findings: Findings, view: View, index: int, patch: Patch) -> bool:
    """Refuse a patch whose centre is not seen; warn where a corner is cut off. Returns whether the centre is seen."""
    path = ("observe", index, "patch")
    center = view.sight(patch.center)
    if center.depth_m <= 0:
        findings.error("the patch is behind the camera", "turn the camera, or move the patch", *path)
        return False
    if not center.is_inside:
        what = f"the patch is outside the picture (its centre is at {center.x:.3g}, {center.y:.3g} of +-1)"
        findings.error(what, "turn or widen the camera, or move the patch", *path)
        return False
    corners = [view.sight(corner) for corner in corners_of(patch)]
    thin = min(_pixels_between(view, corners[0], end) for end in (corners[1], corners[2]))
    if thin < LEAST_PIXELS:
        what = f"the patch is {thin:.2g} pixels wide in the picture, which leaves nothing to measure on it"
        findings.error(what, "make the patch larger, go closer, or render more pixels", *path)
    cut = [corner for corner in corners if not corner.is_inside]
    if cut:
        what = f"{len(cut)} of the patch's 4 corners are outside the picture"
        findings.warning(what, "make the patch smaller, or the view wider", *path)
    return True


def _pixels_between(view: View, start: Sighting, end: Sighting) -> float:
    """The length of an edge in the picture, pixels; endless where an end is behind the camera."""
    if min(start.depth_m, end.depth_m) <= 0:
        return math.inf
    return math.hypot((end.x - start.x) * view.width / 2, (end.y - start.y) * view.height / 2)


def _check_facing(findings: Findings, view: View, index: int, patch: Patch) -> None:
    """Warn of a patch seen edge-on."""
    normal = unit(cross(patch.u, patch.v))
    cosine = abs(dot(normal, view.sight_line(patch.center)))
    if cosine < FACING:
        what = f"the patch is seen edge-on (cosine {cosine:.2g})"
        findings.warning(what, "raise the camera above its plane", "observe", index, "patch")


def _check_on_surface(findings: Findings, world: World, index: int, patch: Patch) -> None:
    """Warn of a patch that lies on no object, as then its metres are those of empty space."""
    if any(isinstance(solid, PlacedMesh) for solid in world.solids):
        return
    slack = OFF_SURFACE * (length(patch.u) + length(patch.v) + length(patch.center))
    bulge = slack + CURVED * (length(patch.u) + length(patch.v))
    if not any(_holds(solid, patch, slack, bulge) for solid in world.solids):
        what = "the patch lies on no object's surface"
        findings.warning(what, "move it onto the surface it is to measure", "observe", index, "patch")


def _holds(solid: Solid, patch: Patch, slack: float, bulge: float) -> bool:
    """Whether the middle of a patch lies on a solid, and its corners nearly do."""
    middle, *corners = solid.distances([patch.center, *corners_of(patch)])
    return middle <= slack and all(corner <= bulge for corner in corners)


def _check_unhidden(findings: Findings, world: World, index: int, observation: Observation) -> None:
    """Walk from the patch's centre to the camera in small steps, and report what stands in between.

    Thin things between two steps are missed; what is found is there.
    """
    center = observation.patch.center
    direction = world.view.direction_to(center)
    shares = (np.arange(_STEPS) + 0.5) / _STEPS
    points = np.asarray(center) - np.outer(shares, direction)
    slack = OFF_SURFACE * (length(direction) + length(center))
    for other, (item, solid) in enumerate(zip(world.scene.objects, world.solids, strict=True)):
        if not solid.is_closed or world.is_room(other) or float(solid.depth(points).max()) <= slack:
            continue
        if not world.material(other).is_transmissive:
            what = f"`{item.name}` hides the patch from the camera"
            findings.warning(what, "move the camera or the patch", "observe", index, "patch")
        elif observation.phenomenon not in THROUGH_GLASS:
            what = f"the camera sees the patch through `{item.name}`, which bends the view"
            findings.warning(what, "move the camera so that nothing is in between", "observe", index, "patch")
