"""Caustic paths: light -> specular objects -> diffuse receiver -> camera, as bounds allow them.

The reasoning only ever drops what geometry proves impossible: a path is kept when the light may reach the specular
object, the object may send light to the receiver, and the camera may see the receiver, directly or by way of any
specular object in view. What stands in between is ignored, but for infinite planes that cut off all of a light.
"""

from __future__ import annotations

from vitrail.geometry.bounds import bounds_of
from vitrail.geometry.placement import place
from vitrail.plan.convexity import never_meets_itself
from vitrail.plan.light_reach import may_reach
from vitrail.plan.occlusion import lies_in_plane_of
from vitrail.plan.plan import CausticPath
from vitrail.plan.upstream import is_shut_off
from vitrail.plan.view import View, view_of
from vitrail.scene.model import Object, Plane, Scene


def specular_objects(scene: Scene) -> tuple[Object, ...]:
    return tuple(item for item in scene.objects if scene.material_of(item).is_specular)


def diffuse_objects(scene: Scene) -> tuple[Object, ...]:
    return tuple(item for item in scene.objects if scene.material_of(item).is_diffuse)


def directly_visible(scene: Scene) -> tuple[Object, ...]:
    """Objects that may be in the picture themselves."""
    view = view_of(scene.camera, scene.image)
    return tuple(item for item in scene.objects if _may_see(view, item))


def visible(scene: Scene) -> tuple[Object, ...]:
    """Objects that may be seen: directly, or in or through a specular object that is in the picture."""
    direct = directly_visible(scene)
    if any(scene.material_of(item).is_specular for item in direct):
        return scene.objects
    return direct


def caustic_paths(scene: Scene) -> tuple[CausticPath, ...]:
    """Every path by which specularly turned light may fall on a diffuse surface that may be seen.

    Light goes on from one specular object to the next, so an object counts as lit when a chain of them leads to it;
    the path names the last one before the receiver.
    """
    receivers = [item for item in visible(scene) if scene.material_of(item).is_diffuse]
    if not receivers:
        return ()
    return tuple(
        CausticPath(light.name, specular.name, receiver.name)
        for light in scene.lights
        for specular in _lit_by_chains(scene, light.name)
        for receiver in receivers
        if may_send(scene, specular, receiver)
    )


def may_send(scene: Scene, source: Object, target: Object) -> bool:
    """Whether light that left ``source`` in a mirrored or refracted direction may fall on ``target``.

    An opaque convex or flat mirror never lights itself where that is seen, and a flat one nothing in its own plane;
    everything else may light everything.
    """
    if lies_in_plane_of(target, source):
        return False
    if source is not target:
        return True
    return not never_meets_itself(scene, source)


def _lit_by_chains(scene: Scene, light_name: str) -> tuple[Object, ...]:
    """Specular objects that a light reaches directly, past every infinite plane, or by way of others."""
    light = next(item for item in scene.lights if item.name == light_name)
    speculars = specular_objects(scene)
    reached = any(may_reach(light, item) and not is_shut_off(scene, light, item) for item in speculars)
    return speculars if reached else ()


def _may_see(view: View, item: Object) -> bool:
    shape = place(item).shape
    return view.may_see_plane(shape) if isinstance(shape, Plane) else view.may_see(bounds_of(item))
