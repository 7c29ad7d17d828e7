"""What this back end refuses before it translates anything, all of it at once."""

from __future__ import annotations

from collections.abc import Iterator

from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray.asked import Asked
from vitrail.lower.povray.photons.radiosity import radiosity_refusals
from vitrail.lower.povray.refusals.refusal import NotTranslatable, Refusals
from vitrail.lower.povray.refusals.undimmed import lamps_in_absorbing_glass
from vitrail.lower.povray.text.roughness import WIDEST_TILT, bumps_of
from vitrail.optics.dispersion import reference_ior
from vitrail.plan.plan import Plan
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Ggx, Material, Scene


def refuse_unsupported(asked: Asked) -> None:
    """Raises NotTranslatable with one diagnostic a place."""
    scene, plan, refusals = asked.scene, asked.plan, asked.refusals
    found = [*_literal_readings(scene, plan, refusals), *_rough_faces(scene, refusals)]
    found += lamps_in_absorbing_glass(asked.world, refusals)
    if scene.transport.indirect == "photons":
        found += radiosity_refusals(asked.world, refusals)
    if found:
        raise NotTranslatable(found)


def _literal_readings(scene: Scene, plan: Plan, refusals: Refusals) -> Iterator[Diagnostic]:
    """The paper's misprints bend and lose light in ways that POV-Ray does not know."""
    paper = scene.paper
    has_glass = any(material.is_transmissive for material in scene.materials.values())
    readings = (
        ("refraction", paper.refraction != "corrected" and has_glass),
        ("tir", paper.tir != "reflect" and plan.requires(Phenomenon.TOTAL_INTERNAL_REFLECTION)),
        ("literal_sum", paper.literal_sum and plan.requires(Phenomenon.ROUGHNESS)),
        ("rough_photons", paper.rough_photons != "reciprocal" and _has_rough_photons(scene, plan)),
        ("count_transmission", paper.count_transmission and has_glass),
        ("shadow", paper.shadow != "opaque" and has_glass and plan.requires(Phenomenon.SHADOW)),
    )
    for key, is_refused in readings:
        if is_refused:
            what = f"POV-Ray cannot follow the literal reading `{key}` of the paper"
            yield refusals.at(what, "render it with the tracer alone, or drop the switch", "paper", key)


def _has_rough_photons(scene: Scene, plan: Plan) -> bool:
    """Whether photons meet a face that is rough by equation 8."""
    by_equation_8 = any(
        material.roughness and not isinstance(material.roughness, Ggx) for material in scene.materials.values()
    )
    return by_equation_8 and (plan.requires(Phenomenon.CAUSTIC) or scene.transport.indirect == "photons")


def _rough_faces(scene: Scene, refusals: Refusals) -> Iterator[Diagnostic]:
    """Bumps tilt normals, and a tilt near a right angle is no face any more."""
    for name, material in scene.materials.items():
        if material.roughness == 0 or not material.is_specular:
            continue
        tilt = _widest_tilt(material)
        if tilt > WIDEST_TILT:
            what = (
                f"this roughness at index {reference_ior(material):g} needs normals tilted by {tilt:.2g} rad on average"
            )
            yield refusals.at(what, "make it smoother, or the index farther from 1", "materials", name, "roughness")


def _widest_tilt(material: Material) -> float:
    """Root mean square tilt of the rougher side, radians; infinite where refraction cannot deflect at all."""
    index = reference_ior(material)
    if material.is_transmissive and index == 1:
        return float("inf")
    sides = [bumps_of(material, index, from_inside=side) for side in (False, True)]
    return max(side.mean_tilt for side in sides if side is not None)
