"""What a reader is told at the top of a readable file: how to render it, its units, and what it only approximates."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from dataclasses import replace

from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray.certificate.certificate import IMAGE, RELATIVE, Certificate, Entry, the_light
from vitrail.lower.povray.certificate.residuals import certificate_of
from vitrail.lower.povray.photons.stored_flux import ONE_STEP
from vitrail.lower.povray.readable.lamps import GRID, GRID_OF_PHOTONS
from vitrail.lower.povray.text.sdl import Comment
from vitrail.lower.povray.translation import Translation
from vitrail.scene.model import Area

WIDTH = 96
"""Characters of a comment's line."""
LOST_AT_EDGES = 0.04
"""Share of the light in a photon disc that POV-Ray's own search misses, where it holds few photons.

Measured on the ball lens with 200 000 photons: 3.6 % in the dim parts of its shadow, 0.5 % in the focus.
"""


def readable_certificate(translation: Translation) -> Certificate:
    """What this one file approximates: as the exact translation, but for storage, search and lamps with an area."""
    kept = [entry for entry in certificate_of(translation).entries if not _is_of_runs(entry)]
    return Certificate((*kept, *_photons(translation), *_lamps(translation), *_camera(translation)))


def _is_of_runs(entry: Entry) -> bool:
    """Whether an entry is about images, light factors or half images, which this file has none of."""
    is_storage = entry.item == "photons" and "8 bits" in entry.target_law
    return entry.item == IMAGE or is_storage or "half image" in entry.target_law


def _photons(translation: Translation) -> Iterator[Entry]:
    if translation.photons is None:
        return
    caustic = Phenomenon.CAUSTIC
    reason = "nothing adjusts the light to these steps; the mean loss is 0.3 %"
    yield Entry(caustic, "photons", "flux in double precision", "8 bits, truncated", ONE_STEP, RELATIVE, reason)
    reason = "POV-Ray's search tree is out of order, so discs lose photons at their edges; most where they hold few"
    yield Entry(caustic, "photons", "every photon in a disc", "nearly every", LOST_AT_EDGES, RELATIVE, reason)


def _lamps(translation: Translation) -> Iterator[Entry]:
    for index, light in enumerate(translation.scene.lights):
        count = sum(source.light == index for source in translation.lighting.halves["a"])
        law, what = f"{count} small ones", "penumbras have steps of one small light"
        if isinstance(light.emitter, Area) and not light.emitter.collimated:
            samples = GRID if translation.photons is None else GRID_OF_PHOTONS
            count, law = samples**2, f"an area_light of {samples} x {samples}"
            what = "POV-Ray multiplies the mean visibility by the mean light, not each by each"
        if count > 1:
            item = the_light(translation.scene, index)
            yield Entry(Phenomenon.SHADOW, item, f"one {light.emitter.key} light", law, 1 / count, RELATIVE, what)


def _camera(translation: Translation) -> Iterator[Entry]:
    """A literal reading of the paper that needs two runs: photons dispersed, and what the camera sees not."""
    if not translation.scene.paper.disperse_camera and translation.plan.requires(Phenomenon.DISPERSION):
        reason = "one file has one index for both; glass seen directly has coloured fringes that the scene has not"
        yield Entry(Phenomenon.DISPERSION, "path", "camera rays undispersed", "dispersed", 1.0, RELATIVE, reason)


def head(translation: Translation, certificate: Certificate, name: str, source: str) -> Iterator[Comment]:
    """The first lines of the file ``name``, made from the scene file ``source``."""
    image, title = translation.scene.image, translation.scene.title
    yield from _wrapped(title or source)
    yield Comment("")
    yield Comment(f"povray +I{name}.pov +O{name}.png +W{image.width} +H{image.height} +A0.05 +AM2 +R3 -J -D")
    yield Comment("")
    yield from _wrapped(f"Written by `vitrail emit povray --readable` from {source}. {_units(translation)}")
    yield Comment("")
    yield from _wrapped("What POV-Ray, in this file, does differently from the scene, and by how much:")
    for entry, phenomena in _by_law(certificate):
        size = f"{entry.residual:.2g} {entry.unit}"
        law = f"{entry.source_law} -> {entry.target_law}"
        yield from _wrapped(f"* {entry.item}, {', '.join(phenomena)}: {law} ({size}). {entry.reason}", indent="  ")
    yield from _wrapped("* picture: 8 bits, white at radiance 1 (the scene's numbers are unbounded)", indent="  ")


def _units(translation: Translation) -> str:
    units, stops = translation.units, translation.scene.image.exposure_stops
    lengths, light = "Lengths are metres", ""
    if units.scale != 1 or any(units.centre):
        origin = " from <" + ", ".join(f"{each:g}" for each in units.centre) + ">" if any(units.centre) else ""
        lengths = (
            f"Lengths are in units of {1 / units.scale:g} m{origin} (POV-Ray's tolerances are too coarse for metres)"
        )
    if stops != 0:
        light = f" All light is times {2.0**stops:g}, for the scene's exposure of {stops:g} stops."
    return f"{lengths}, +y is up, axes are right-handed. Colours are linear.{light}"


def _by_law(certificate: Certificate) -> list[tuple[Entry, list[str]]]:
    """Each law once, with the phenomena it acts on."""
    found: dict[Entry, list[str]] = {}
    for entry in certificate.entries:
        law = replace(entry, phenomenon=Phenomenon.DIFFUSION)
        found.setdefault(law, []).append(entry.phenomenon.value.replace("_", " "))
    return list(found.items())


def _wrapped(text: str, indent: str = "") -> Iterator[Comment]:
    for line in textwrap.wrap(text, WIDTH, subsequent_indent=indent, break_long_words=False) or [""]:
        yield Comment(line)
