"""Light that stays in an absorbing medium from a lamp to a surface: POV-Ray dims it not at all [P 7].

It dims light from face to face, and such light meets no face. Measured at absorption 1 per metre and a metre of way,
for points, rectangles, discs and collimated lamps, on cards, planes, what the glass stands on and the glass's own
diffuse share: POV-Ray shows what it shows without absorption on that way, e times too much.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from vitrail.base.vector import Vec, add, dot, scale, subtract, unit
from vitrail.geometry.lamp import place_of
from vitrail.geometry.placement import solid_of
from vitrail.geometry.shapes.flat import PlacedPlane
from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.lower.povray.refusals.refusal import Refusals
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Area, Light


def lamps_in_absorbing_glass(world: World, refusals: Refusals) -> Iterator[Diagnostic]:
    """Every lamp in absorbing glass that holds, or stands on, something diffuse; at the lamp's place."""
    glasses = [index for index, solid in enumerate(world.solids) if solid.is_closed and _absorbs(world, index)]
    for index, light in enumerate(world.scene.lights):
        for glass in glasses:
            if _holds(world.solids[glass], _places(light)) and _lights_something(world, glass):
                name = world.scene.objects[glass].name
                what = f"POV-Ray does not dim the light of `{light.name}` on its way inside the absorbing `{name}`"
                remedy = "render it with the tracer alone, or move the lamp out of what absorbs"
                yield refusals.at(what, remedy, "lights", index, light.emitter.key)


def _absorbs(world: World, index: int) -> bool:
    material = world.material(index)
    return material.is_transmissive and max(absorption_per_m(material)) > 0


def _places(light: Light) -> list[Vec]:
    """Where light begins; of a lamp with an area its middle, edges and corners. Sun and sky begin outside."""
    place = place_of(light)
    if place is None:
        return []
    if not isinstance(light.emitter, Area):
        return [place]
    lamp = solid_of(light.emitter.shape)
    return [place, *lamp.surface_points(lamp)]


def _lights_something(world: World, glass: int) -> bool:
    """Whether anything diffuse lies in the glass or on it, or is its own share."""
    if world.material(glass).is_diffuse:
        return True
    lies_on = {other for one, other in world.contacts if one == glass}
    body = world.solids[glass]
    for index, solid in enumerate(world.solids):
        if index == glass or not world.material(index).is_diffuse:
            continue
        if index in lies_on or _holds(body, _surface(solid, body)) or _is_cut(body, solid):
            return True
    return False


def _holds(glass: Solid, points: list[Vec]) -> bool:
    return bool(points) and bool((glass.depth(np.array(points, float)) > 0).any())


def _surface(solid: Solid, glass: Solid) -> list[Vec]:
    """Points on a surface; of a plane its own, and for a half space of glass the one that lies deep in it."""
    if not isinstance(solid, PlacedPlane):
        return solid.surface_points(glass)
    point = solid.shape.point
    found = [point]
    if isinstance(glass, PlacedPlane):
        normal, down = unit(solid.shape.normal), scale(unit(glass.shape.normal), -1.0)
        along = subtract(down, scale(normal, dot(down, normal)))
        if (size := dot(along, along)) > 0:
            above = max(0.0, -float(glass.depth(np.array([point], float))[0]))
            found.append(add(point, scale(along, (above + 1) / size)))
    return found


def _is_cut(glass: Solid, solid: Solid) -> bool:
    """Whether a plane runs through the glass: it has points on both sides."""
    if not isinstance(solid, PlacedPlane):
        return False
    points = glass.surface_points(solid)
    depths = solid.depth(np.array(points, float)) if points else np.zeros(1)
    return bool(depths.min() < 0 < depths.max())
