"""Why a phenomenon is required, or not, in sentences with names and numbers."""

from __future__ import annotations

from typing import assert_never

from vitrail.plan.facts import Facts
from vitrail.plan.plan import Requirement
from vitrail.scene.model import Ambient, Material, Object
from vitrail.scene.phenomenon import Phenomenon


def requirement(phenomenon: Phenomenon, facts: Facts) -> Requirement:
    """The decision about one phenomenon."""
    match phenomenon:
        case Phenomenon.DIFFUSION:
            return _diffusion(facts)
        case Phenomenon.REFLECTION:
            return _reflection(facts)
        case Phenomenon.REFRACTION:
            return _refraction(facts)
        case Phenomenon.TOTAL_INTERNAL_REFLECTION:
            return _total_internal_reflection(facts)
        case Phenomenon.COLOURED_TRANSMISSION:
            return _coloured_transmission(facts)
        case Phenomenon.ABSORPTION:
            return _absorption(facts)
        case Phenomenon.CAUSTIC:
            return _caustic(facts)
        case Phenomenon.ROUGHNESS:
            return _roughness(facts)
        case Phenomenon.DISPERSION:
            return _dispersion(facts)
        case Phenomenon.SHADOW:
            return _shadow(facts)
        case Phenomenon.INDIRECT_LIGHT:
            return _indirect_light(facts)
        case _:
            assert_never(phenomenon)


def _diffusion(facts: Facts) -> Requirement:
    items = [
        item for item in facts.seen if facts.material(item).is_diffuse or facts.material(item).emission is not None
    ]
    return _of(items, facts, "diffuse or glowing, and may be seen", "nothing diffuse can be seen", "shadow rays")


def _reflection(facts: Facts) -> Requirement:
    items = [i for i in facts.active if max(facts.material(i).reflection) > 0 or facts.material(i).fresnel]
    return _of(items, facts, "mirrors", "nothing that mirrors is on a path to the camera", "one more ray a face")


def _refraction(facts: Facts) -> Requirement:
    return _of(list(facts.active_glass), facts, "refracts", "no glass is on a path to the camera", "two rays a body")


def _total_internal_reflection(facts: Facts) -> Requirement:
    items = [item for item in facts.active_glass if facts.material(item).ior != 1.0]
    if facts.chain.proven and facts.chain.reflections == 0:
        return Requirement(False, (facts.chain.reason,), "none")
    return _of(items, facts, "may reflect totally", "no face can reflect totally", "longer chains")


def _coloured_transmission(facts: Facts) -> Requirement:
    items = [item for item in facts.active_glass if _is_coloured(facts.material(item))]
    return _of(items, facts, "colours what it lets through", "all glass passes the channels alike", "none")


def _absorption(facts: Facts) -> Requirement:
    items = [item for item in facts.active_glass if _absorbs(facts.material(item))]
    return _of(items, facts, "absorbs along the way", "no glass absorbs inside", "one exponential a crossing")


def _caustic(facts: Facts) -> Requirement:
    evidence = tuple(f"`{p.light}` -> `{p.specular}` -> `{p.receiver}` -> camera" for p in facts.paths)
    if not evidence:
        return Requirement(False, ("no path light -> specular -> diffuse -> camera",), "none")
    return Requirement(True, evidence, "one photon pass")


def _roughness(facts: Facts) -> Requirement:
    items = [item for item in facts.active if facts.material(item).roughness != 0]
    return _of(
        items, facts, "is rough", "every specular face is smooth", f"{facts.scene.paper.rough_samples} rays a face"
    )


def _dispersion(facts: Facts) -> Requirement:
    items = [item for item in facts.active_glass if facts.material(item).is_dispersive]
    return _of(items, facts, "disperses", "no dispersive glass is on a path to the camera", "one path a band")


def _shadow(facts: Facts) -> Requirement:
    if not facts.diffuse_seen or not facts.lights:
        return Requirement(False, ("no lit diffuse surface can be seen",), "none")
    if len(facts.scene.objects) == 1:
        return Requirement(False, (f"`{facts.scene.objects[0].name}` is alone",), "none")
    return Requirement(
        True, (f"{len(facts.scene.objects)} objects may stand in each other's light",), "one ray a light"
    )


def _indirect_light(facts: Facts) -> Requirement:
    indirect = facts.scene.transport.indirect
    if isinstance(indirect, Ambient):
        return Requirement(True, ("a constant ambient irradiance is asked for",), "none")
    if indirect == "none" or not facts.diffuse_seen:
        return Requirement(False, ("`transport.indirect` is none",), "none")
    return Requirement(True, ("`transport.indirect` is photons",), "a global photon map and a final gather")


def _of(items: list[Object], facts: Facts, yes: str, no: str, cost: str) -> Requirement:
    """Required by each of ``items``, which is named; not required without any."""
    if not items:
        return Requirement(False, (no,), "none")
    return Requirement(True, tuple(f"`{item.name}` ({item.material}) {yes}" for item in items), cost)


def _is_coloured(material: Material) -> bool:
    return len(set(material.transmission)) > 1 or _absorbs(material)


def _absorbs(material: Material) -> bool:
    return material.attenuation is not None or max(material.absorption_per_m or (0.0,)) > 0


def could_occur(phenomenon: Phenomenon, scene: Scene) -> tuple[bool, tuple[str, ...]]:
    """Whether the materials and the transport of a scene allow a phenomenon at all, wherever its objects are."""
    materials = [scene.material_of(item) for item in scene.objects]
    glass = [material for material in materials if material.is_transmissive]
    specular = any(material.is_specular for material in materials)
    match phenomenon:
        case Phenomenon.DIFFUSION | Phenomenon.SHADOW:
            return True, ("always",)
        case Phenomenon.REFLECTION | Phenomenon.CAUSTIC:
            return specular, ("a specular material",)
        case Phenomenon.REFRACTION | Phenomenon.TOTAL_INTERNAL_REFLECTION | Phenomenon.COLOURED_TRANSMISSION:
            return bool(glass), ("a transmissive material",)
        case Phenomenon.ABSORPTION:
            return any(_absorbs(material) for material in glass), ("an absorbing material",)
        case Phenomenon.ROUGHNESS:
            return any(m.is_specular and m.roughness != 0 for m in materials), ("a rough material",)
        case Phenomenon.DISPERSION:
            return any(material.is_dispersive for material in glass), ("a dispersive material",)
        case Phenomenon.INDIRECT_LIGHT:
            return scene.transport.indirect != "none", ("`transport.indirect`",)
        case _:
            assert_never(phenomenon)
