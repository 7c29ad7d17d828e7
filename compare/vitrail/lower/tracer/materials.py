"""Materials and bands as the tracer reads them: indices resolved per band, absorption per metre."""

from __future__ import annotations

from decimal import Decimal
from typing import Any, assert_never

from vitrail.base.colour import Triplet
from vitrail.base.phenomenon import Phenomenon
from vitrail.optics.bands import ALL_LIGHT, Band, band_model
from vitrail.optics.dispersion import ior_by_band, reference_ior
from vitrail.plan.plan import Plan
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.model import Checker, Ggx, Material, Scene

Json = dict[str, Any]


def bands_of(scene: Scene, plan: Plan, wavelength_nm: float | None = None) -> tuple[Band, ...]:
    """One band unless the plan requires dispersion; with ``wavelength_nm`` light of that wavelength alone."""
    if wavelength_nm is not None:
        return (Band(f"{wavelength_nm:g} nm", (1.0, 1.0, 1.0), wavelength_nm),)
    if not plan.requires(Phenomenon.DISPERSION):
        return (ALL_LIGHT,)
    return band_model(scene.transport.bands).bands


def lowered_material(name: str, scene: Scene, bands: tuple[Band, ...]) -> Json:
    """One material; ``camera_ior`` is the index of a ray that is not split into bands."""
    material = scene.materials[name]
    indices = ior_by_band(material, bands, scene.paper)
    return {
        "name": name,
        "diffuse": _texture(material.diffuse),
        "reflection": material.reflection,
        "transmission": material.transmission,
        "ior_by_band": indices,
        "ior_minus_one_by_band": [_minus_one(index) for index in indices],
        "camera_ior": reference_ior(material),
        "fresnel": material.fresnel,
        "absorption_per_m": absorption_per_m(material),
        "emission": _texture(material.emission or (0.0, 0.0, 0.0)),
        "roughness": _roughness(material),
    }


def _minus_one(index: float) -> float:
    """n - 1 of the decimal that the scene gives: for 1.000000000001 exactly 1e-12, in binary 9e-5 off [O 2.2]."""
    return float(Decimal(repr(index)) - 1)


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
