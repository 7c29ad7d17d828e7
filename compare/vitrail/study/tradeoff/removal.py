"""A scene in which one phenomenon does not happen, all else as it was: how the study learns what it contributes.

Some phenomena are switched by the plan, and left out like any that a scene does not require. The others are what the
materials do; they are taken out of the materials.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import assert_never

from vitrail.base.changed import changed
from vitrail.base.colour import Triplet
from vitrail.base.phenomenon import Phenomenon
from vitrail.plan.plan import Plan, Requirement
from vitrail.scene.model import Material, Scene

Fields = Mapping[str, object]
"""Fields of a material by name, with what takes their place."""

HOW: dict[Phenomenon, str] = {
    Phenomenon.DIFFUSION: "no surface scatters light",
    Phenomenon.REFLECTION: "no ray is mirrored, not even inside glass",
    Phenomenon.REFRACTION: "light goes through glass straight on, with the share that the face had",
    Phenomenon.TOTAL_INTERNAL_REFLECTION: "what cannot leave the glass is lost",
    Phenomenon.COLOURED_TRANSMISSION: "glass is grey, with the mean of its channels",
    Phenomenon.ABSORPTION: "glass is clear inside",
    Phenomenon.CAUSTIC: "no light is sent through or off glass",
    Phenomenon.ROUGHNESS: "every face is smooth",
    Phenomenon.DISPERSION: "one index for all colours",
    Phenomenon.SHADOW: "nothing stands in the way of lamps",
    Phenomenon.INDIRECT_LIGHT: "diffuse surfaces do not light each other",
}


def without(scene: Scene, plan: Plan, phenomenon: Phenomenon) -> tuple[Scene, Plan]:
    """The scene and its plan less one phenomenon; the plan is not analysed again, so nothing else changes."""
    gone = Requirement(False, ("taken out by the study",), "none")
    less = replace(plan, entries={**plan.entries, phenomenon: gone})
    match phenomenon:
        case Phenomenon.REFLECTION:
            return scene, replace(less, chain=replace(plan.chain, reflections=0))
        case Phenomenon.TOTAL_INTERNAL_REFLECTION:
            paper = changed(scene.paper, tir="drop")
            return changed(scene, paper=paper), less
        case Phenomenon.DIFFUSION:
            return _with_materials(scene, lambda material: {"diffuse": (0.0, 0.0, 0.0)}), less
        case Phenomenon.REFRACTION:
            return _with_materials(scene, _straight), less
        case Phenomenon.COLOURED_TRANSMISSION:
            return _with_materials(scene, _grey), less
        case (
            Phenomenon.ABSORPTION
            | Phenomenon.CAUSTIC
            | Phenomenon.ROUGHNESS
            | Phenomenon.DISPERSION
            | Phenomenon.SHADOW
            | Phenomenon.INDIRECT_LIGHT
        ):
            return scene, less
        case _:
            assert_never(phenomenon)


def _with_materials(scene: Scene, change: Callable[[Material], Fields]) -> Scene:
    materials = {name: changed(material, **change(material)) for name, material in scene.materials.items()}
    return changed(scene, materials=materials)


def _straight(material: Material) -> Fields:
    """Index 1 for glass; a Fresnel mirror then reflects nothing."""
    if not material.is_transmissive:
        return {}
    return {"ior": 1.0, "dispersion": None, "glass": None}


def _grey(material: Material) -> Fields:
    """The mean of the channels in every colour that light takes on inside or at the faces."""
    if not material.is_transmissive:
        return {}
    update: dict[str, object] = {"transmission": _mean(material.transmission)}
    if material.absorption_per_m is not None:
        update["absorption_per_m"] = _mean(material.absorption_per_m)
    if material.attenuation is not None:
        colour = _mean(material.attenuation.color)
        update["attenuation"] = changed(material.attenuation, color=colour)
    return update


def _mean(colour: Triplet) -> Triplet:
    return (sum(colour) / 3,) * 3
