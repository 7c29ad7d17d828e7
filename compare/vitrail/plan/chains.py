"""How many mirrorings and crossings of a glass face one path can make, where geometry proves a limit."""

from __future__ import annotations

from vitrail.plan.bounds import bounds_of
from vitrail.plan.light_paths import is_convex_or_flat
from vitrail.plan.plan import Chain
from vitrail.scene.model import Area, Material, Object, Scene, Sphere
from vitrail.scene.vector import length, subtract


def longest_chain(scene: Scene) -> Chain:
    """The longest specular chain of a scene, never above what ``transport`` allows.

    Three cases have a proof; every other keeps the limits of the scene, and says so.
    """
    limits = scene.transport
    specular = [item for item in scene.objects if scene.material_of(item).is_specular]
    if not specular:
        return _chain(scene, 0, 0, "no specular object")
    if len(specular) == 1 and _is_one_mirror(scene.material_of(specular[0]), specular[0]):
        return _chain(scene, 1, 0, f"`{specular[0].name}` is the only mirror and never mirrors itself")
    if len(specular) == 1 and _is_crossed_once(scene, specular[0]):
        return _chain(scene, 0, 2, f"`{specular[0].name}` is a sphere without mirror share: in and out")
    names = ", ".join(f"`{item.name}`" for item in specular)
    return Chain(limits.max_reflections, limits.max_transmissions, False, f"no limit proven for {names}")


def _chain(scene: Scene, reflections: int, transmissions: int, reason: str) -> Chain:
    limits = scene.transport
    return Chain(min(reflections, limits.max_reflections), min(transmissions, limits.max_transmissions), True, reason)


def _is_one_mirror(material: Material, item: Object) -> bool:
    """An opaque mirror that is convex or flat: a mirrored ray leaves it for good."""
    return not material.is_transmissive and is_convex_or_flat(item)


def _is_crossed_once(scene: Scene, item: Object) -> bool:
    """A smooth ball of glass without mirror share, entered from outside: what gets in leaves at the next face.

    A ray inside a ball meets every face at the angle at which it entered, so it is never totally reflected. That
    needs n > 1, a smooth face, and the camera and all lamps outside.
    """
    material, shape = scene.material_of(item), item.shape
    if not isinstance(shape, Sphere) or max(material.reflection) > 0 or material.fresnel or material.roughness != 0:
        return False
    if material.is_diffuse or (material.ior is not None and material.ior < 1) or material.dispersion is not None:
        return False
    ball = bounds_of(item)
    inner = shape.radius * (1 + 1e-9)
    emitters = [light.emitter for light in scene.lights]
    points = [scene.camera.position] + [p for e in emitters if (p := getattr(e, "position", None)) is not None]
    areas = any(isinstance(emitter, Area) for emitter in emitters)
    return not areas and all(length(subtract(point, ball.centre)) > inner for point in points)
