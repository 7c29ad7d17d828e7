"""Evidence for shadows: which object may stand between which light and which seen surface, and how soft its edge is."""

from __future__ import annotations

import math

from vitrail.base.vector import length, subtract
from vitrail.geometry.bounds import Bounds
from vitrail.geometry.lamp import bounds_of_light
from vitrail.plan.evidence.words import needed, not_needed, pixels
from vitrail.plan.facts import Facts
from vitrail.plan.lever import lever_on
from vitrail.plan.light_reach import may_reach
from vitrail.plan.occlusion import may_shadow
from vitrail.plan.plan import Requirement
from vitrail.scene.model import Area, Directional, Environment, Light, Object, Point, Spot


def shadow(facts: Facts) -> Requirement:
    """Refused only where no object can stand in any light of any seen diffuse surface."""
    receivers = [(item, facts.world.solid(item)) for item in facts.diffuse_seen]
    lit = [(light, item) for light in facts.lights for item, solid in receivers if may_reach(light, solid)]
    if not lit:
        return not_needed("no light reaches a diffuse surface that can be seen")
    evidence = []
    for light, receiver in lit:
        occluders = [item for item in facts.scene.objects if may_shadow(facts.world, light, receiver, item)]
        if occluders:
            names = ", ".join(f"`{item.name}`" for item in occluders)
            evidence.append(
                f"{names} may shadow `{receiver.name}` from `{light.name}`{_edge(facts, light, occluders, receiver)}"
            )
    if not evidence:
        return not_needed("nothing can stand between a light and a surface that is seen")
    return needed(evidence, f"one ray a sample and light ({len(facts.lights)})")


def _edge(facts: Facts, light: Light, occluders: list[Object], receiver: Object) -> str:
    """The width of the penumbra of the first finite occluder, where the light has a size."""
    finite = [item for item in occluders if item is not receiver and facts.world.bounds(item).is_finite]
    if not finite:
        return ""
    size = _apparent_size(light, facts.world.bounds(finite[0]))
    if size == 0:
        return ""
    lever = lever_on(facts.world, finite[0], receiver)
    return f", with an edge about {pixels(size * lever.typical_px)} wide"


def _apparent_size(light: Light, bounds: Bounds) -> float:
    """Angle across a light as seen from these bounds, radians; 0 for points and parallel light, 2 pi for the sky."""
    emitter = light.emitter
    match emitter:
        case Directional():
            return math.radians(emitter.angular_diameter_deg)
        case Point() | Spot():
            return 0.0
        case Area():
            if emitter.collimated:
                return 0.0
            lamp = bounds_of_light(light)
            away = length(subtract(lamp.centre, bounds.centre))
            return 2 * math.atan2(lamp.radius_m, away)
        case Environment():
            return 2 * math.pi
