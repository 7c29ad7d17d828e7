"""Known mistakes to put into a translation on purpose: each must turn its phenomenon red, or the harness is blind.

These are the three that every run of the tests injects. A defect edits the nodes of the finished scene, as the mistake
of a translator would, and how the images of the runs are added up. Where it finds no node to edit it raises
NothingToEdit: a harness whose defects change nothing would be green for nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace

from vitrail.lower.povray import PovrayRun, PovrayScene
from vitrail.lower.povray.text.edit import Edit, NothingToEdit, blocks, coloured, edited, found, statements, values_of
from vitrail.lower.povray.text.sdl import Block, Colour, Part, SdlFile, Statement, statement
from vitrail.pipeline.defect import Defect

Change = Callable[[PovrayScene], PovrayScene]
"""A mistake in a translated scene; raises NothingToEdit."""

BRIGHTER = 256.0
"""More light with less gain leaves the picture as it is; more than this could overflow the half floats of the image."""
TOO_MUCH_FLUX = 64.0
"""POV-Ray drops photons of flux 32 and more without a word [P 2.4]."""
WIDER = 32.0
"""Widening of the spacing for lamps: the flux of their photons depends on their distance, and no sensible choice of
spacing is so far from the limit."""


def everywhere(edit: Edit) -> Change:
    """Edit what draws and what shoots photons, in every run."""
    return _of_scene(lambda run: _drawing(_shooting(run, edit), edit))


def in_drawing(edit: Edit) -> Change:
    """Edit what draws, and not what shoots the photons."""
    return _of_scene(lambda run: _drawing(run, edit))


def in_shooting(edit: Edit) -> Change:
    """Edit what shoots the photons, and not what draws."""
    return _of_scene(lambda run: _shooting(run, edit))


def _of_scene(change: Callable[[PovrayRun], PovrayRun]) -> Change:
    def apply(scene: PovrayScene) -> PovrayScene:
        runs = tuple(change(run) for run in scene.runs)
        if runs == scene.runs:
            raise NothingToEdit("the defect finds nothing to change in this scene")
        return replace(scene, runs=runs)

    return apply


def _drawing(run: PovrayRun, edit: Edit) -> PovrayRun:
    return _redrawn(run, lambda file: edited(file, edit))


def _redrawn(run: PovrayRun, change: Callable[[SdlFile], SdlFile]) -> PovrayRun:
    """A run with all its pictures changed alike."""
    return replace(run, pictures=tuple(replace(each, scene=change(each.scene)) for each in run.pictures))


def _shooting(run: PovrayRun, edit: Edit) -> PovrayRun:
    return run if run.photon_scene is None else replace(run, photon_scene=edited(run.photon_scene, edit))


def brighter_lights(factor: float) -> Edit:
    """Multiply the colour of every light."""

    def brighter(colour: Colour) -> Colour:
        red, green, blue = colour.channels
        return Colour((red * factor, green * factor, blue * factor))

    return blocks("light_source", coloured(brighter))


def naive_fade(interior: Block) -> Block:
    """Paste colour and distance of the attenuation into a fade, which wants one minus the coefficient.

    The colour is stated where a tenth of the strongest channel is left, as an author of a material would.
    """
    return Block(interior.head, tuple(each for part in interior.parts for each in _faded(part)))


def _faded(part: Part) -> tuple[Part, ...]:
    """A medium as the three statements of a fade; any other part as it is."""
    absorption = values_of(part, "absorption") if isinstance(part, Block) and part.head == "media" else None
    if absorption is None:
        return (part,)
    (colour,) = absorption
    assert isinstance(colour, Colour)
    distance = math.log(10) / max(colour.channels)
    red, green, blue = (math.exp(-each * distance) for each in colour.channels)
    return (
        statement("fade_distance", distance),
        statement("fade_power", 1001),
        statement("fade_color", Colour((red, green, blue))),
    )


def _overflow(scene: PovrayScene) -> PovrayScene:
    """Fewer photons of more light: the picture keeps its brightness, but photons no longer fit their number format."""
    if all(run.photon_scene is None for run in scene.runs):
        raise NothingToEdit("the defect finds no photons to change in this scene")
    brighter = everywhere(brighter_lights(BRIGHTER))(scene)
    runs = []
    for run in brighter.runs:
        red, green, blue = (each / BRIGHTER for each in run.gain)
        photons = None if run.photon_scene is None else sparse_photons(run.photon_scene)
        runs.append(replace(_redrawn(run, sparse_photons), photon_scene=photons, gain=(red, green, blue)))
    return replace(brighter, runs=tuple(runs))


def sparse_photons(file: SdlFile) -> SdlFile:
    """Widen the spacing until a photon of the brightest parallel light carries too much."""
    spacing = next((each for block in found(file, "photons") if (each := _spacing(block)) is not None), None)
    if spacing is None:
        return file
    colours = [_red(light) for light in found(file, "light_source") if values_of(light, "parallel") is not None]
    wider = math.sqrt(TOO_MUCH_FLUX / (max(colours) * spacing**2)) if colours else WIDER
    return edited(file, statements("spacing", to=(spacing * max(wider, 1.0),)))


def _spacing(photons: Block) -> float | None:
    values = values_of(photons, "spacing")
    return None if values is None else float(values[0])  # type: ignore[arg-type]


def _red(light: Block) -> float:
    """The red channel of a light's colour."""
    colours = [
        each for part in light.parts if isinstance(part, Statement) for each in part.values if isinstance(each, Colour)
    ]
    return colours[0].channels[0]


DEFECTS: Mapping[str, Defect] = {
    defect.name: defect
    for defect in (
        Defect("missing_pi", povray=everywhere(brighter_lights(math.pi))),
        Defect("naive_fade", povray=everywhere(blocks("interior", naive_fade))),
        Defect("photon_overflow", povray=_overflow),
    )
}
