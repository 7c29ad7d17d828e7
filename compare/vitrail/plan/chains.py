"""How many mirrorings and crossings of a glass face one path can make, where geometry proves a limit.

A total reflection counts with the crossings: it sends back the light that would have crossed.
"""

from __future__ import annotations

from vitrail.base.vector import length, subtract
from vitrail.geometry.shapes.flat import PlacedPlane
from vitrail.geometry.shapes.sphere import PlacedSphere
from vitrail.geometry.world import World
from vitrail.plan.convexity import NEAR, camera_may_be_inside, never_meets_itself
from vitrail.plan.plan import Chain
from vitrail.plan.stated_error import SHARE
from vitrail.scene.model import Area, Material, Object, Point, Scene, Spot


def longest_chain(world: World) -> Chain:
    """The longest specular chain of a scene, never above what ``transport`` allows.

    A few cases have a proof; every other keeps the limits of the scene, and says so. The literal readings of the paper
    bend light in ways that the proofs do not cover or count it otherwise, and interreflection starts new chains
    anywhere.
    """
    scene = world.scene
    specular = [item for item in scene.objects if scene.material_of(item).is_specular]
    if not specular:
        return _chain(scene, 0, 0, "nothing mirrors or refracts")
    by_the_letter = scene.paper.refraction != "corrected" or scene.paper.count_transmission
    if not by_the_letter and scene.transport.indirect != "photons":
        if len(specular) == 1 and never_meets_itself(world, specular[0]):
            return _chain(scene, 1, 0, f"`{specular[0].name}` is the only mirror and never mirrors itself")
        if len(specular) == 1 and _is_crossed_once(world, specular[0]):
            return _chain(scene, 0, 2, f"`{specular[0].name}` is a ball without mirror share: light gets in and out")
        if all(_is_invisible(scene.material_of(item)) and world.solid(item).is_convex_or_flat for item in specular):
            faces = sum(1 if isinstance(world.solid(item), PlacedPlane) else 2 for item in specular)
            return _chain(scene, 0, faces, "all glass has index 1 and mirrors nothing: light goes straight on")
        if len(specular) == 1 and _traps_nothing(world, specular[0]):
            return _in_and_out(scene, specular[0])
    return _unproven(scene, specular)


def _unproven(scene: Scene, specular: list[Object]) -> Chain:
    """The limits of the scene, but no reflection where nothing has a mirror share and no crossing where all is opaque.

    Where both count as one, the limit of reflections is that of all and stays.
    """
    limits = scene.transport
    names = ", ".join(f"`{item.name}`" for item in specular[:8]) + (" and more" if len(specular) > 8 else "")
    materials = [scene.material_of(item) for item in specular]
    mirrors = any(_mirrors(material) for material in materials) or scene.paper.count_transmission
    reflections = limits.max_reflections if mirrors else 0
    transmissions = limits.max_transmissions if any(material.is_transmissive for material in materials) else 0
    return Chain(reflections, transmissions, False, f"no limit is proven for {names}")


def _chain(scene: Scene, reflections: int, transmissions: int, reason: str) -> Chain:
    limits = scene.transport
    return Chain(min(reflections, limits.max_reflections), min(transmissions, limits.max_transmissions), True, reason)


def _in_and_out(scene: Scene, ball: Object) -> Chain:
    """Light gets into a ball and out once; only how often it is mirrored inside stays without a limit."""
    limits = scene.transport
    reflections = limits.max_reflections if _mirrors(scene.material_of(ball)) else 0
    reason = f"no limit of reflections is proven inside `{ball.name}`, which light enters and leaves once"
    return Chain(reflections, min(2, limits.max_transmissions), False, reason)


def _traps_nothing(world: World, item: Object) -> bool:
    """A smooth ball of glass that all light enters from outside: it may be mirrored inside, but never totally.

    A ray inside a ball meets every face at the angle at which it entered. One that is totally reflected at the outside,
    where the ball is the thinner medium, never meets it again.
    """
    material = world.scene.material_of(item)
    return material.is_transmissive and material.roughness == 0 and _is_entered_from_outside(world, item)


def _is_invisible(material: Material) -> bool:
    """Glass of index 1 without mirror share, dispersion or roughness: a ray passes as if it were not there."""
    return (
        material.is_transmissive
        and material.ior == 1
        and not material.is_dispersive
        and max(material.reflection) == 0
        and material.roughness == 0
    )


def _is_crossed_once(world: World, item: Object) -> bool:
    """A smooth ball of glass without mirror share, entered from outside: what gets in leaves at the next face.

    A ray inside a ball meets every face at the angle at which it entered, so it is never totally reflected. That
    needs an index above 1 for every colour and a smooth face that scatters nothing (scattered light starts inside).
    """
    return _passes_only(world.scene.material_of(item)) and _is_entered_from_outside(world, item)


def _is_entered_from_outside(world: World, item: Object) -> bool:
    """A ball with the camera and all lamps outside."""
    ball, lights = world.solid(item), world.scene.lights
    if not isinstance(ball, PlacedSphere):
        return False
    if any(isinstance(light.emitter, Area) for light in lights) or camera_may_be_inside(world, item):
        return False
    lamps = [light.emitter.position for light in lights if isinstance(light.emitter, Point | Spot)]
    center, radius = ball.shape.center, ball.shape.radius
    return all(length(subtract(lamp, center)) > radius * (1 + NEAR) for lamp in lamps)


def _passes_only(material: Material) -> bool:
    """Light that meets a face is transmitted or lost, at an index above 1."""
    bends_inward = material.ior is not None and material.ior > 1 and material.dispersion is None
    return bends_inward and not _mirrors(material) and not material.is_diffuse and material.roughness == 0


def _mirrors(material: Material) -> bool:
    """Light is mirrored at a face even where it could be let through."""
    return max(material.reflection) >= SHARE or material.fresnel
