"""Materials and bands as the tracer reads them: indices resolved per band, absorption per metre."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, assert_never

from vitrail.plan.plan import Plan
from vitrail.scene.model import Checker, Ggx, Material, Scene
from vitrail.scene.phenomenon import Phenomenon

Json = dict[str, Any]
Triplet = tuple[float, float, float]
BLACK: Triplet = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Band:
    """A part of the light that keeps one index; the weights of all bands add up to white."""

    name: str
    weight: Triplet
    wavelength_nm: float | None


ALL_LIGHT = Band("all", (1.0, 1.0, 1.0), None)


def bands_of(scene: Scene, plan: Plan, wavelength_nm: float | None = None) -> tuple[Band, ...]:
    """One band unless the plan requires dispersion."""
    return (ALL_LIGHT,)


def lowered_material(name: str, scene: Scene, plan: Plan, bands: tuple[Band, ...]) -> Json:
    """One material with what the plan does not require taken out."""
    material = scene.materials[name]
    indices = [material.ior if material.ior is not None else 1.0 for _ in bands]
    return {
        "name": name,
        "diffuse": _texture(material.diffuse),
        "reflection": material.reflection,
        "transmission": material.transmission,
        "ior_by_band": indices,
        "ior_minus_one_by_band": [index - 1.0 for index in indices],
        "camera_ior": indices[0],
        "fresnel": material.fresnel,
        "absorption_per_m": absorption_per_m(material) if plan.requires(Phenomenon.ABSORPTION) else BLACK,
        "emission": _texture(material.emission or BLACK),
        "roughness": _roughness(material) if plan.requires(Phenomenon.ROUGHNESS) else {"kind": "none"},
    }


def absorption_per_m(material: Material) -> Triplet:
    """Beer-Lambert coefficients, 1/m: the given ones, or -ln(color) / distance."""
    if material.absorption_per_m is not None:
        return material.absorption_per_m
    if material.attenuation is None:
        return BLACK
    color, distance = material.attenuation.color, material.attenuation.distance
    return (-math.log(color[0]) / distance, -math.log(color[1]) / distance, -math.log(color[2]) / distance)


def _texture(texture: Triplet | Checker) -> Any:
    match texture:
        case Checker():
            return {"checker": {"colors": texture.checker.colors, "size": texture.checker.size}}
        case tuple():
            return texture
        case _:
            assert_never(texture)


def _roughness(material: Material) -> Json:
    """[S eq. 8] with its lambda, or the microfacet width; a smooth face is none of them."""
    roughness = material.roughness
    match roughness:
        case Ggx():
            return {"kind": "ggx", "alpha": roughness.ggx}
        case float() | int():
            return {"kind": "equation_8", "value": float(roughness)} if roughness > 0 else {"kind": "none"}
        case _:
            assert_never(roughness)
