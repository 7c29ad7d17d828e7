"""Scenes with something switched off, to learn where two engines differ: pure functions from a scene to a scene.

What is off is off in the scene itself, so that every engine is given the same physics. `study/tradeoff/removal.py`
switches the tracer's plan instead, which another engine cannot follow.

Nothing can be switched off without something else changing. Each ablation says what it surely takes away (``absent``:
a deviation that stays is none of these) and all that it may touch (``touched``: one that goes is one of these).
Diffusion cannot be switched off, because nothing would be seen; total reflection only together with refraction.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from vitrail.base.changed import changed
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.vector import length
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.world import World
from vitrail.optics.dispersion import ior_position, reference_ior
from vitrail.plan.occlusion import may_shadow
from vitrail.plan.plan import Plan
from vitrail.scene.model import Ggx, Material, Object, Patch, Scene

P = Phenomenon
BLACK = (0.0, 0.0, 0.0)
OF_SPECULAR_BODIES = frozenset(P) - {P.DIFFUSION, P.SHADOW, P.INDIRECT_LIGHT}
"""What only bodies that mirror or refract do to light."""

ON_SURFACE = 1e-6
"""A patch lies on an object whose surface is nearer than this share of its size."""


Change = Callable[[Material], dict[str, Any]]
"""Fields of a material to replace, by name."""


@dataclass(frozen=True)
class Ablation:
    """``name`` is what is off, ``words`` how, as a clause; ``darkens``: that the patch gets dark is what is wanted."""

    name: str
    words: str
    absent: frozenset[Phenomenon]
    touched: frozenset[Phenomenon]
    scene: Scene
    darkens: bool = False


def ablations(world: World, plan: Plan) -> tuple[Ablation, ...]:
    """Everything that can be switched off in a scene and that its plan requires, the narrowest change first."""
    scene = world.scene
    found = [*_of_materials(scene, plan), *_of_light(world, plan), *_of_bodies(scene, plan)]
    return tuple(each for each in found if each.scene != scene and each.scene.objects)


def _of_materials(scene: Scene, plan: Plan) -> list[Ablation]:
    """What lies in the materials: colour, absorption, roughness, dispersion, mirroring, bending."""

    def off(phenomenon: Phenomenon, words: str, change: Change, *also: Phenomenon) -> Ablation:
        touched = frozenset({phenomenon, *also})
        return Ablation(phenomenon.value, words, frozenset({phenomenon}), touched, _with_materials(scene, change))

    middle = 1.5 - ior_position(scene.paper)
    step = middle / (3 if scene.paper.dispersion == "span" else 1)
    found = [
        off(P.DISPERSION, "all light takes the index of the middle band", lambda m: _of_one_index(m, step)),
        off(P.ROUGHNESS, "every face is smooth", lambda m: {"roughness": 0.0} if m.roughness else {}),
        off(P.ABSORPTION, "glass is clear inside", _clear_inside),
        off(P.COLOURED_TRANSMISSION, "glass lets all colours through its faces", _clear_faces),
        off(P.REFLECTION, "glass mirrors nothing and mirrors are perfect", _without_mirroring, *_split(scene)),
        _straight_on(scene),
    ]
    return [each for each in found if plan.requires(P(each.name))]


def _straight_on(scene: Scene) -> Ablation:
    """Glass of index 1: light goes on as it came, and no caustic is gathered."""
    absent = {P.REFRACTION, P.TOTAL_INTERNAL_REFLECTION, P.DISPERSION}
    touched = absent | {P.CAUSTIC}
    glass = [material for material in map(scene.material_of, scene.objects) if material.is_transmissive]
    if any(material.fresnel for material in glass):
        touched |= {P.REFLECTION}
    if any(isinstance(material.roughness, Ggx) for material in glass):
        touched |= {P.ROUGHNESS}
    words = "glass has index 1 and bends nothing"
    return Ablation(P.REFRACTION.value, words, frozenset(absent), frozenset(touched), _with_materials(scene, _unbent))


def _of_light(world: World, plan: Plan) -> list[Ablation]:
    """Indirect light, and the shadows of opaque bodies."""
    scene, found = world.scene, []
    if plan.requires(P.INDIRECT_LIGHT):
        transport = changed(scene.transport, indirect="none")
        own, dark = frozenset({P.INDIRECT_LIGHT}), changed(scene, transport=transport)
        found.append(Ablation(P.INDIRECT_LIGHT.value, "surfaces do not light each other", own, own, dark))
    if plan.requires(P.SHADOW):
        names = {item.name for item in _blockers(world)}
        kept = tuple(item for item in scene.objects if item.name not in names)
        touched = frozenset({P.SHADOW, P.INDIRECT_LIGHT})
        words = "opaque bodies that may shadow the patch are taken away"
        less = changed(scene, objects=kept)
        found.append(Ablation(P.SHADOW.value, words, frozenset({P.SHADOW}), touched, less))
    return found


def _of_bodies(scene: Scene, plan: Plan) -> list[Ablation]:
    """Bodies that mirror or refract: black, so that they cast nothing but a shadow, and not there at all."""
    found = []
    if plan.requires(P.CAUSTIC):
        black = _with_materials(scene, lambda m: _without_specular(m) if m.is_specular else {})
        touched = frozenset(P) - {P.SHADOW}
        words = "bodies that mirror or refract are black"
        found.append(Ablation(P.CAUSTIC.value, words, OF_SPECULAR_BODIES, touched, black, darkens=True))
    touched = OF_SPECULAR_BODIES | {P.SHADOW, P.INDIRECT_LIGHT}
    words = "bodies that mirror or refract are taken away"
    found.append(Ablation("specular bodies", words, OF_SPECULAR_BODIES, touched, _bare(scene)))
    return found


def _with_materials(scene: Scene, change: Change) -> Scene:
    """Change the materials that objects have; one that none has is nobody's business."""
    used = {item.material for item in scene.objects}
    altered = {name: changed(scene.materials[name], **change(scene.materials[name])) for name in used}
    return changed(scene, materials={**scene.materials, **altered})


def _of_one_index(material: Material, middle_steps: float) -> dict[str, Any]:
    """The index in the middle of the paper's four bands, or of the d line, where the spectrum stays in its place."""
    if not material.is_dispersive:
        return {}
    step = material.dispersion if isinstance(material.dispersion, float | int) else 0.0
    return {"ior": reference_ior(material) + middle_steps * step, "dispersion": None, "glass": None}


def _clear_inside(material: Material) -> dict[str, Any]:
    return {"attenuation": None, "absorption_per_m": None} if material.is_transmissive else {}


def _clear_faces(material: Material) -> dict[str, Any]:
    """All light that the face neither scatters nor mirrors goes through."""
    if not material.is_transmissive:
        return {}
    taken = max(d + r for d, r in zip(material.diffuse_peak, material.reflection, strict=True))
    return {"transmission": (max(1.0 - taken, 0.0),) * 3}


def _without_mirroring(material: Material) -> dict[str, Any]:
    """Glass sends on what Fresnel would have mirrored, and loses its own share r; an opaque mirror returns all."""
    if material.is_transmissive:
        return {"reflection": BLACK, "transmission": _passing(material), "fresnel": False}
    if max(material.reflection) > 0:
        return {"reflection": (1.0 - max(material.diffuse_peak),) * 3, "fresnel": False}
    return {}


def _unbent(material: Material) -> dict[str, Any]:
    """Index 1. Fresnel then mirrors nothing, and microfacets bend nothing."""
    if not material.is_transmissive:
        return {}
    index = {"ior": 1.0, "dispersion": None, "glass": None}
    smooth = {"roughness": 0.0} if isinstance(material.roughness, Ggx) else {}
    pooled = {"reflection": BLACK, "transmission": _passing(material), "fresnel": False} if material.fresnel else {}
    return {**index, **smooth, **pooled}


def _passing(material: Material) -> tuple[float, float, float]:
    """What goes through a face that mirrors nothing: Fresnel's pool r + t, or t alone."""
    if not material.fresnel:
        return material.transmission
    r, t = material.reflection, material.transmission
    return (min(r[0] + t[0], 1.0), min(r[1] + t[1], 1.0), min(r[2] + t[2], 1.0))


def _without_specular(material: Material) -> dict[str, Any]:
    """Only what the face scatters or glows is left."""
    faces = {"reflection": BLACK, "transmission": BLACK, "fresnel": False, "roughness": 0.0}
    return {**faces, "ior": None, "glass": None, "dispersion": None, "attenuation": None, "absorption_per_m": None}


def _bare(scene: Scene) -> Scene:
    """Without bodies that only mirror or refract; one that scatters or glows too stays, and does nothing else."""

    def is_only_specular(item: Object) -> bool:
        material = scene.material_of(item)
        return material.is_specular and not material.is_diffuse and material.emission is None

    kept = tuple(item for item in scene.objects if not is_only_specular(item))
    matt = _with_materials(scene, lambda m: _without_specular(m) if m.is_specular else {})
    return changed(matt, objects=kept)


def _split(scene: Scene) -> tuple[Phenomenon, ...]:
    """Where Fresnel's formula splits the light, the share that is mirrored is missing in what is refracted."""
    has_fresnel = any(
        material.fresnel and material.is_transmissive for material in map(scene.material_of, scene.objects)
    )
    return (P.REFRACTION,) if has_fresnel else ()


def _blockers(world: World) -> tuple[Object, ...]:
    """Opaque bodies that may stand between a light and a surface with a patch, and carry none themselves."""
    scene = world.scene
    patches = [observation.patch for observation in scene.observe]
    carriers = [item for item in scene.objects if any(_carries(world, item, patch) for patch in patches)]
    opaque = [item for item in scene.objects if not scene.material_of(item).is_specular and item not in carriers]
    return tuple(
        item
        for item in opaque
        if any(may_shadow(world, light, carrier, item) for light in scene.lights for carrier in carriers)
    )


def _carries(world: World, item: Object, patch: Patch) -> bool:
    """Whether a patch lies on an object; on a mesh, which is not read here, it may."""
    near = ON_SURFACE * (length(patch.u) + length(patch.v) + length(patch.center))
    solid = world.solid(item)
    return isinstance(solid, PlacedMesh) or solid.distance(patch.center) <= near
