"""Caustic paths: light -> specular objects -> diffuse receiver -> camera, as bounds allow them.

The reasoning only ever drops what geometry proves impossible: a path is kept when the light may reach the specular
object, the object may send light to the receiver, and the camera may see the receiver, directly or by way of any
specular object in view. What stands in between is ignored, but for infinite planes that cut off all of a light.
"""

from __future__ import annotations

from vitrail.geometry.world import World
from vitrail.plan.convexity import never_meets_itself
from vitrail.plan.in_picture import may_see
from vitrail.plan.light_reach import may_reach
from vitrail.plan.occlusion import lies_in_plane_of
from vitrail.plan.plan import CausticPath
from vitrail.plan.planes_between import is_shut_off
from vitrail.scene.model import Light, Object, Scene


def specular_objects(scene: Scene) -> tuple[Object, ...]:
    return tuple(item for item in scene.objects if scene.material_of(item).is_specular)


def directly_visible(world: World) -> tuple[Object, ...]:
    """Objects that may be in the picture themselves."""
    return tuple(item for item in world.scene.objects if may_see(world.view, world.solid(item)))


def visible(world: World) -> tuple[Object, ...]:
    """Objects that may be seen: directly, or in or through a specular object that is in the picture."""
    direct, scene = directly_visible(world), world.scene
    if any(scene.material_of(item).is_specular for item in direct):
        return scene.objects
    return direct


def caustic_paths(world: World) -> tuple[CausticPath, ...]:
    """Every path by which specularly turned light may fall on a diffuse surface that may be seen.

    Light goes on from one specular object to the next, so an object counts as lit when a chain of them leads to it;
    the path names the last one before the receiver.
    """
    scene = world.scene
    receivers = [item for item in visible(world) if scene.material_of(item).is_diffuse]
    if not receivers:
        return ()
    return tuple(
        CausticPath(light.name, specular.name, receiver.name)
        for light in scene.lights
        for specular in _lit_by_chains(world, light)
        for receiver in receivers
        if may_send(world, specular, receiver)
    )


def may_send(world: World, source: Object, target: Object) -> bool:
    """Whether light that left ``source`` in a mirrored or refracted direction may fall on ``target``.

    An opaque convex or flat mirror never lights itself where that is seen, and a flat one nothing in its own plane;
    everything else may light everything.
    """
    if lies_in_plane_of(world.solid(target), world.solid(source)):
        return False
    if source is not target:
        return True
    return not never_meets_itself(world, source)


def _lit_by_chains(world: World, light: Light) -> tuple[Object, ...]:
    """Specular objects that a light reaches directly, past every infinite plane, or by way of others."""
    speculars = specular_objects(world.scene)
    reached = any(may_reach(light, world.solid(item)) and not is_shut_off(world, light, item) for item in speculars)
    return speculars if reached else ()
