"""The certificate of a translation: one entry for every law that POV-Ray follows differently."""

from __future__ import annotations

from collections.abc import Iterator

from vitrail.base.phenomenon import Phenomenon
from vitrail.base.vector import length
from vitrail.lower.povray.bodies.contact import REACH, Grown
from vitrail.lower.povray.bodies.gaps import Shrunk
from vitrail.lower.povray.bodies.nesting import HAIR
from vitrail.lower.povray.certificate.certificate import (
    HALF_FLOAT,
    IMAGE,
    RELATIVE,
    Certificate,
    CutBy,
    Entry,
    the_object,
)
from vitrail.lower.povray.certificate.light_residuals import light_entries
from vitrail.lower.povray.certificate.material_residuals import longest_lived_share, material_entries, trapped_share
from vitrail.lower.povray.certificate.photon_residuals import photon_entries
from vitrail.lower.povray.photons.depth import TraceDepth
from vitrail.lower.povray.photons.radiosity import radiosity_entries
from vitrail.lower.povray.translation import Translation
from vitrail.scene.absorption import absorption_per_m

IN_AND_OUT = 2
"""Transmissions of a path through a lone ball: so far POV-Ray's counter cuts reflections where the scene does."""


def certificate_of(translation: Translation) -> Certificate:
    """Everything that differs, most general first, in the names of the scene."""
    return Certificate(
        (
            *_output(translation),
            *_position(translation),
            *_gaps(translation),
            *_contacts(translation),
            *_cuts(translation),
            *_depth(translation),
            *light_entries(translation),
            *_indirect(translation),
            *material_entries(translation.scene, translation.mode, translation.indices),
            *photon_entries(translation),
        )
    )


def _output(translation: Translation) -> Iterator[Entry]:
    for phenomenon in Phenomenon:
        if translation.plan.requires(phenomenon):
            meant, shown = "radiance in double precision", "half-float image"
            reason = "POV-Ray's linear output has 11 bits a channel"
            yield Entry(phenomenon, IMAGE, meant, shown, HALF_FLOAT, RELATIVE, reason)


def _position(translation: Translation) -> Iterator[Entry]:
    """The scale is a power of two and loses nothing; a shift rounds once."""
    units = translation.units
    away = length(units.centre)
    if away > 0:
        yield Entry(
            Phenomenon.REFRACTION,
            "scene",
            "coordinates as written",
            f"moved by {away:.6g} m, times {units.scale:g}",
            away * 2.0**-53,
            "m",
            "single-precision photons and absolute tolerances need the scene near the origin",
        )


def _gaps(translation: Translation) -> Iterator[Entry]:
    for shrunk in translation.bodies.placement.shrunk:
        yield Entry(
            Phenomenon.REFRACTION,
            the_object(translation.scene, shrunk.index),
            "touching surfaces",
            f"a gap of {shrunk.depth_m:.3g} m",
            shrunk.share,
            RELATIVE,
            "POV-Ray loses one of two faces nearer than 1e-4 units; the solid shrinks by that much all round",
        )
        yield from _other_way(translation, shrunk)


def _contacts(translation: Translation) -> Iterator[Entry]:
    for grown in translation.bodies.joined.grown:
        yield Entry(
            Phenomenon.REFRACTION,
            the_object(translation.scene, grown.index),
            "a face that lies on another body",
            f"a solid larger by {grown.depth_m:.3g} m, which reaches into the other",
            grown.share,
            RELATIVE,
            f"POV-Ray loses one of two faces nearer than 1e-4 units; the solid grows by steps of {REACH:g} units",
        )
        yield from _other_way(translation, grown)


def _other_way(translation: Translation, changed: Shrunk | Grown) -> Iterator[Entry]:
    """Light crosses a solid of another size on a way that is longer or shorter by both its faces."""
    scene = translation.scene
    absorption = max(absorption_per_m(scene.material_of(scene.objects[changed.index])))
    if absorption > 0 and translation.plan.requires(Phenomenon.ABSORPTION):
        yield Entry(
            Phenomenon.ABSORPTION,
            the_object(scene, changed.index),
            "the way through the solid as written",
            f"longer or shorter by {2 * changed.depth_m:.3g} m",
            2 * changed.depth_m * absorption,
            RELATIVE,
            "straight through two faces, in the channel that absorbs most",
        )


def _cuts(translation: Translation) -> Iterator[Entry]:
    """Lower solids cut by higher ones; air is cut out exactly."""
    hair = HAIR / translation.units.scale
    for index, cuts in enumerate(translation.bodies.nesting.cuts):
        for cut in cuts:
            if not cut.is_air:
                yield Entry(
                    Phenomenon.REFRACTION,
                    CutBy(the_object(translation.scene, index), the_object(translation.scene, cut.by)),
                    "one face where the higher priority begins",
                    f"two, {hair:.3g} m apart",
                    hair,
                    "m",
                    "light enters the higher solid at its own face and the lower one at the cut inside it",
                )


def _depth(translation: Translation) -> Iterator[Entry]:
    """Path weights below a limit, and limits of depth that count otherwise."""
    plan, scene, depth = translation.plan, translation.scene, translation.depth
    if not any(material.is_specular for material in scene.materials.values()):
        return
    shown = Phenomenon.REFRACTION if plan.requires(Phenomenon.REFRACTION) else Phenomenon.REFLECTION
    kept, reason = (
        f"weights above {depth.adc_bailout:g}",
        "each way out of a path loses at most one such branch; two on average",
    )
    yield Entry(shown, "path", "every branch", kept, 2 * depth.adc_bailout, RELATIVE, reason)
    if depth.wanted > depth.limit:
        yield _too_deep(depth, shown)
    if not depth.is_proven:
        yield from _one_counter(translation, shown)


def _one_counter(translation: Translation, shown: Phenomenon) -> Iterator[Entry]:
    """Paths that the scene ends because one of its two counters is full, and POV-Ray lets go on."""
    chain, level = translation.plan.chain, translation.depth.level
    if chain.transmissions <= IN_AND_OUT:
        return
    specular = [material for material in translation.scene.materials.values() if material.is_specular]
    mirrored = max(longest_lived_share(material) for material in specular)
    crossed = max(trapped_share(material) for material in specular) if chain.reflections > 0 else 0.0
    for most, what, share in (
        (chain.reflections, "reflections", mirrored),
        (chain.transmissions, "transmissions", crossed),
    ):
        if share > 0:
            yield Entry(
                shown,
                "path",
                f"at most {most} {what}",
                f"at most {level} levels of both kinds",
                share ** (most + 1),
                "of a path",
                "what a path weighs that has one more; how many there are depends on the shapes",
            )


def _too_deep(depth: TraceDepth, shown: Phenomenon) -> Entry:
    return Entry(
        shown,
        "path",
        f"{depth.wanted} levels",
        f"POV-Ray's limit of {depth.limit}",
        float(depth.wanted - depth.level),
        "levels",
        "what lies behind so many faces is black",
    )


def _indirect(translation: Translation) -> Iterator[Entry]:
    if translation.scene.transport.indirect == "photons":
        yield from radiosity_entries(translation.scene, translation.settings.quality)
