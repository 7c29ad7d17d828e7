"""A scene as one commented file that a person renders with one command and edits.

It is the same translation as the exact one, in native mode: materials, shapes, gaps and nesting are written by the same
code. It gives up what needs several runs: one run for each channel and band, two half images, light factors and ordered
photon maps. What that costs stands at the top of the file, by ``readable_certificate``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from vitrail.geometry.world import World
from vitrail.lower.povray.certificate.certificate import Certificate
from vitrail.lower.povray.photons.photons import FLUX_LIMIT, PhotonPass, photon_flux
from vitrail.lower.povray.readable.camera import readable_camera
from vitrail.lower.povray.readable.identifiers import Identifiers, file_stem
from vitrail.lower.povray.readable.lamps import readable_lamps
from vitrail.lower.povray.readable.notes import head, readable_certificate
from vitrail.lower.povray.readable.objects import readable_objects
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.printer import Layout, printed
from vitrail.lower.povray.text.scene_text import DARK, SceneText
from vitrail.lower.povray.text.sdl import Blank, Comment, Directive, Part, SdlFile, block, present
from vitrail.lower.povray.translation import Translation, translate
from vitrail.plan.plan import Plan
from vitrail.plan.settings import ReferenceMode, Settings, read_settings

LAYOUT = Layout(width=88, one_line=frozenset(), digits=10, breaks_lists=True)
"""A person reads shorter lines, lists value by value, and no digits that only rounding made."""


@dataclass(frozen=True)
class ReadableScene:
    """``files``: name to text, the scene first; ``skies``: name to pixels; what it approximates."""

    files: Mapping[str, str]
    skies: Mapping[str, np.ndarray]
    certificate: Certificate

    @property
    def text(self) -> str:
        """The scene itself."""
        return next(iter(self.files.values()))


def lower_readable(world: World, plan: Plan, settings: Settings, source: str) -> ReadableScene:
    """The scene of the file named ``source``. Raises NotTranslatable with the lines of the scene's file."""
    native = read_settings({**settings.as_record(), "reference_mode": ReferenceMode.NATIVE})
    translation = translate(world, plan, native, is_readable=True)
    exposure = Exposure(light_factor=2.0**translation.scene.image.exposure_stops)
    translation = replace(translation, photons=_storable(translation, exposure))
    stem, identifiers, text = file_stem(source.rpartition(".")[0] or source), Identifiers(), SceneText(translation)
    objects = readable_objects(translation, exposure, identifiers, stem)
    lamps = readable_lamps(translation, exposure, identifiers, stem)
    certificate, sky = readable_certificate(translation), text.sky_picture(exposure)
    parts: tuple[Part | None, ...] = (
        *head(translation, certificate, stem, source),
        Blank(),
        Directive("version", 3.7),
        text.settings(exposure),
        Comment("nothing glows or scatters unless its material says so"),
        block("#default", block("finish", *DARK)),
        text.background(exposure, sky),
        readable_camera(translation.scene.camera, translation.units),
        *_titled("Lights", lamps.parts),
        *_titled("Materials", objects.materials),
        *_titled("Objects", objects.parts),
        *_patches(translation),
    )
    files = {f"{stem}.pov": SdlFile(present(parts)), **lamps.beside, **objects.beside}
    skies = {} if sky is None else {sky.name: sky.pixels}
    return ReadableScene({name: printed(file, LAYOUT) for name, file in files.items()}, skies, certificate)


def _storable(translation: Translation, exposure: Exposure) -> PhotonPass | None:
    """The photon pass, dense enough that no photon carries more than POV-Ray can store [P 2.4]."""
    photons = translation.photons
    if photons is None:
        return None
    spacing, lights = photons.spacing["a"], translation.lighting.halves["a"]
    while any(
        photon_flux(source, ball, spacing, max(exposure.light(source.strength))) > FLUX_LIMIT
        for source in lights
        for ball in photons.targets
    ):
        spacing /= 2
    return replace(photons, spacing={"a": spacing, "b": spacing})


def _titled(title: str, parts: tuple[Part, ...]) -> tuple[Part, ...]:
    rule = "-" * (80 - len(title))
    return (Blank(), Comment(f"--- {title} {rule}"), *parts) if parts else ()


def _patches(translation: Translation) -> Iterator[Part]:
    """Where the scene is measured: rectangles by centre and half edges."""
    if not translation.scene.observe:
        return
    yield from (Blank(), Comment(f"--- What the scene observes {'-' * 59}"))
    for entry in translation.scene.observe:
        patch, units = entry.patch, translation.units
        centre, u, v = units.point(patch.center), units.vector(patch.u), units.vector(patch.v)
        words = ", ".join(f"<{x:g}, {y:g}, {z:g}>" for x, y, z in (centre, u, v))
        yield Comment(f"{entry.name}: {entry.phenomenon.value.replace('_', ' ')} at centre, half edges {words}")
