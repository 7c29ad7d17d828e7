"""Light that stays in an absorbing medium from a lamp to a surface: POV-Ray dims it not at all [P 7].

It dims light from face to face, and such light meets no face. Measured at absorption 1 per metre and a metre of way,
for points, rectangles, discs and collimated lamps, on cards, planes, what the glass stands on and the glass's own
diffuse share: POV-Ray shows what it shows without absorption on that way, e times too much.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from vitrail.base.vector import Vec, add, dot, scale, subtract, unit
from vitrail.geometry.inside import depth_in, is_solid
from vitrail.geometry.placement import Placed, place
from vitrail.geometry.surface_points import surface_points
from vitrail.lower.povray.bodies.contact import NO_TURN, touching
from vitrail.lower.povray.refusals.refusal import Refusals
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Area, Directional, Environment, Light, Object, Plane, Point, Scene, Spot


def lamps_in_absorbing_glass(scene: Scene, refusals: Refusals) -> Iterator[Diagnostic]:
    """Every lamp in absorbing glass that holds, or stands on, something diffuse; at the lamp's place."""
    glasses = [item for item in scene.objects if is_solid(item) and _absorbs(scene, item)]
    for index, light in enumerate(scene.lights):
        for glass in glasses:
            if _holds(glass, _places(light)) and _lights_something(scene, glass):
                what = (
                    f"POV-Ray does not dim the light of `{light.name}` on its way inside the absorbing `{glass.name}`"
                )
                remedy = "render it with the tracer alone, or move the lamp out of what absorbs"
                yield refusals.at(what, remedy, "lights", index, light.emitter.key)


def _absorbs(scene: Scene, item: Object) -> bool:
    material = scene.material_of(item)
    return material.is_transmissive and max(absorption_per_m(material)) > 0


def _places(light: Light) -> list[Vec]:
    """Where light begins; of a lamp with an area its middle, edges and corners. Sun and sky begin outside."""
    match light.emitter:
        case Point() | Spot() as emitter:
            return [emitter.position]
        case Area() as emitter:
            placed = Placed(emitter.shape, NO_TURN)
            return [emitter.shape.center, *surface_points(placed, placed)]
        case Directional() | Environment():
            return []


def _lights_something(scene: Scene, glass: Object) -> bool:
    """Whether anything diffuse lies in the glass or on it, or is its own share."""
    if scene.material_of(glass).is_diffuse:
        return True
    index = scene.objects.index(glass)
    lies_on = {scene.objects[other].name for one, other in touching(scene) if one == index}
    for item in scene.objects:
        if item is glass or not scene.material_of(item).is_diffuse:
            continue
        if item.name in lies_on or _holds(glass, _surface(item, glass)) or _is_cut(glass, item):
            return True
    return False


def _holds(glass: Object, points: list[Vec]) -> bool:
    return bool(points) and bool((depth_in(glass, np.array(points, float)) > 0).any())


def _surface(item: Object, glass: Object) -> list[Vec]:
    """Points on a surface; of a plane its own, and for a half space of glass the one that lies deep in it."""
    if not isinstance(item.shape, Plane):
        return surface_points(place(item), place(glass))
    point, found = item.shape.point, [item.shape.point]
    if isinstance(glass.shape, Plane):
        normal, down = unit(item.shape.normal), scale(unit(glass.shape.normal), -1.0)
        along = subtract(down, scale(normal, dot(down, normal)))
        if (size := dot(along, along)) > 0:
            above = max(0.0, -float(depth_in(glass, np.array([point], float))[0]))
            found.append(add(point, scale(along, (above + 1) / size)))
    return found


def _is_cut(glass: Object, item: Object) -> bool:
    """Whether a plane runs through the glass: it has points on both sides."""
    if not isinstance(item.shape, Plane):
        return False
    points = surface_points(place(glass), place(item))
    depths = depth_in(item, np.array(points, float)) if points else np.zeros(1)
    return bool(depths.min() < 0 < depths.max())
