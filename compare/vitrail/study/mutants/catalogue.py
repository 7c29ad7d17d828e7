"""The mutants, one line each: mistakes that translators and tracers are known to make."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray import PovrayScene
from vitrail.lower.povray.text.edit import Edit, NothingToEdit, blocks, statements, values_of
from vitrail.lower.povray.text.sdl import Block, Part, Product, Statement, Vector, statement
from vitrail.pipeline.defect import Defect
from vitrail.pipeline.defects import DEFECTS, brighter_lights, everywhere, in_drawing, in_shooting
from vitrail.study.mutants import misreadings as misread
from vitrail.study.mutants.mutant import Mutant

P = Phenomenon
Lowered = dict[str, Any]
"""The tracer's scene, which a mutant changes in place."""


def _written(name: str, phenomenon: Phenomenon, what: str, edit: Edit) -> Mutant:
    """A mistake in how the scene is written, wherever the edit finds a node."""
    return Mutant(name, "translator", phenomenon, what, Defect(name, povray=everywhere(edit)))


def _misread(name: str, phenomenon: Phenomenon, what: str, reading: misread.Misreading) -> Mutant:
    return Mutant(name, "translator", phenomenon, what, Defect(name, misread_by_povray=reading))


def _tracer_misread(name: str, phenomenon: Phenomenon, what: str, reading: misread.Misreading) -> Mutant:
    return Mutant(name, "tracer", phenomenon, what, Defect(name, misread_by_tracer=reading))


def _in_tracer(name: str, phenomenon: Phenomenon, what: str, change: Callable[[Lowered], None]) -> Mutant:
    def apply(lowered: Lowered) -> Lowered:
        change(lowered)
        return lowered

    return Mutant(name, "tracer", phenomenon, what, Defect(name, tracer=apply))


def _known(name: str, phenomenon: Phenomenon, what: str) -> Mutant:
    return Mutant(name, "translator", phenomenon, what, DEFECTS[name])


def _mirrored(part: Part) -> Part:
    """The camera's right-hand vector turned round."""
    if isinstance(part, Statement) and part.keyword == "right" and isinstance(part.values[1], Vector):
        return statement("right", Product(-1, part.values[1]))
    return part


def _shadowless(light: Block) -> Block:
    """A lamp whose light passes everything; one that shines through an aperture does so anyway [P 1.3]."""
    is_projected = any(isinstance(part, Block) and part.head == "projected_through" for part in light.parts)
    return light if is_projected else Block(light.head, (*light.parts, statement("shadowless")))


def _unshadowed(part: Part) -> Part:
    """A target of photons that casts no shadow."""
    if not isinstance(part, Block) or not any(_aims_photons(each) for each in part.parts):
        return part
    no_shadow = statement("no_shadow")
    return Block(
        part.head,
        tuple(each for inner in part.parts for each in ((no_shadow, inner) if _aims_photons(inner) else (inner,))),
    )


def _aims_photons(part: Part) -> bool:
    return isinstance(part, Block) and part.head == "photons" and values_of(part, "target") is not None


def _drop_total_reflection(lowered: Lowered) -> None:
    lowered["paper"]["tir"] = "drop"


def _lose_photons(lowered: Lowered) -> None:
    lowered["plan"]["caustic"] = False


def _white_bands(lowered: Lowered) -> None:
    """Every band an even share of white: the weights still add up, and the spectrum has no colours."""
    count = len(lowered["bands"])
    for band in lowered["bands"]:
        band["weight"] = [1 / count] * 3


def _loud_bands(scene: PovrayScene) -> PovrayScene:
    """Bands as pure colours: each carries the whole of its channels, so that together they are more than white."""
    if len({run.name for run in scene.runs if "_band" in run.name}) < 2:
        raise NothingToEdit("the defect finds no bands to change in this scene")
    most = [max(run.gain[channel] for run in scene.runs) for channel in range(3)]
    loud = [tuple(top if own > 0 else 0.0 for own, top in zip(run.gain, most, strict=True)) for run in scene.runs]
    # Blue is the last band's alone, at full weight; red and green are shared by two bands at half weight each.
    whole = [(2 * red, 2 * green, blue) for red, green, blue in loud]
    return replace(scene, runs=tuple(replace(run, gain=gain) for run, gain in zip(scene.runs, whole, strict=True)))


def _lambert_without_fresnel(lowered: Lowered) -> None:
    for material in lowered["materials"]:
        material["fresnel"] = False


TRANSLATOR = (
    _known("missing_pi", P.DIFFUSION, "light colours are irradiance instead of irradiance over pi"),
    _written("gamma", P.DIFFUSION, "assumed_gamma 2.2", statements("assumed_gamma", 1, to=(2.2,))),
    _written("flipped_axis", P.DIFFUSION, "the camera is left-handed: pictures are mirrored", _mirrored),
    _written(
        "missing_cosine", P.DIFFUSION, "brilliance 0: no cosine", statements("diffuse", 1, to=(1, "brilliance", 0))
    ),
    _written("half_falloff", P.DIFFUSION, "falloff 1/r instead of 1/r^2", statements("fade_power", 2, to=(1,))),
    _written(
        "default_finish",
        P.DIFFUSION,
        "the default ambient of 0.1 is left in place",
        statements("ambient", 0, to=(0.1,)),
    ),
    _written("no_shadows", P.SHADOW, "every lamp is shadowless", blocks("light_source", _shadowless)),
    _misread("point_lamps", P.SHADOW, "area lights shrink to their centre", misread.smaller_lamps(0.05)),
    _misread("lost_ambient", P.INDIRECT_LIGHT, "ambient light is forgotten", misread.transport(indirect="none")),
    _misread(
        "squared_mirror",
        P.REFLECTION,
        "the mirror's colour is applied twice",
        misread.materials(lambda m: {} if m.is_transmissive else {"reflection": misread.power(m.reflection, 2)}),
    ),
    _misread(
        "white_mirror",
        P.REFLECTION,
        "mirrors take the mean of their colour",
        misread.materials(lambda m: {} if m.is_transmissive else {"reflection": (sum(m.reflection) / 3,) * 3}),
    ),
    _misread("fresnel_off", P.REFRACTION, "Fresnel's share is forgotten", misread.glass(lambda m: {"fresnel": False})),
    _misread("wrong_line", P.REFRACTION, "the index of another spectral line", misread.glass(misread.with_index(1.02))),
    _written("shallow", P.REFRACTION, "rays end at the third face", statements("max_trace_level", to=(3,))),
    _misread(
        "tint_once",
        P.COLOURED_TRANSMISSION,
        "a pane is tinted once instead of at both faces",
        misread.glass(lambda m: {"transmission": misread.power(m.transmission, 0.5)}),
    ),
    _misread(
        "tint_twice",
        P.COLOURED_TRANSMISSION,
        "each face is tinted twice",
        misread.glass(lambda m: {"transmission": misread.power(m.transmission, 2)}),
    ),
    _misread(
        "blue_green_red",
        P.COLOURED_TRANSMISSION,
        "channels of the glass in the wrong order",
        misread.glass(lambda m: {"transmission": m.transmission[::-1]}),
    ),
    _known("naive_fade", P.ABSORPTION, "colour and distance of attenuation pasted into fade_color"),
    _misread("absorbs_twice", P.ABSORPTION, "absorption is doubled", misread.glass(misread.with_absorption(2))),
    _misread("half_roughness", P.ROUGHNESS, "alpha for its square", misread.materials(misread.with_roughness(0.5))),
    _misread("smooth", P.ROUGHNESS, "roughness is forgotten", misread.materials(misread.with_roughness(0))),
    _misread("red_for_blue", P.DISPERSION, "the sign of dispersion", misread.glass(misread.with_dispersion(-1))),
    _misread("narrow_spread", P.DISPERSION, "5 % of the spread is lost", misread.glass(misread.with_dispersion(0.95))),
    Mutant(
        "loud_bands",
        "translator",
        P.DISPERSION,
        "band weights that do not sum to white",
        Defect("loud_bands", povray=_loud_bands),
    ),
    _known("photon_overflow", P.CAUSTIC, "photons of flux 32 and more, which POV-Ray drops without a word"),
    _misread("moved_caustic", P.CAUSTIC, "a lens sits 3 mm aside", misread.moved_balls(3e-3)),
    Mutant(
        "weak_photons",
        "translator",
        P.CAUSTIC,
        "photons carry 1 % less than light does",
        Defect("weak_photons", povray=in_shooting(brighter_lights(0.99))),
    ),
    Mutant(
        "counted_twice",
        "translator",
        P.CAUSTIC,
        "light through glass counts straight on, because glass casts no shadow, and again as photons",
        Defect("counted_twice", povray=in_drawing(_unshadowed)),
    ),
)

TRACER = (
    _tracer_misread("bright_sun", P.DIFFUSION, "pi for 3: lights 5 % too bright", misread.brighter_suns(math.pi / 3)),
    _tracer_misread("no_ambient", P.INDIRECT_LIGHT, "ambient light is skipped", misread.transport(indirect="none")),
    _in_tracer(
        "dropped_total", P.TOTAL_INTERNAL_REFLECTION, "total reflection drops the t share", _drop_total_reflection
    ),
    _in_tracer("no_fresnel", P.REFRACTION, "Fresnel's branch is never taken", _lambert_without_fresnel),
    _tracer_misread(
        "tint_2_percent",
        P.COLOURED_TRANSMISSION,
        "2 % more green",
        misread.glass(
            lambda m: {"transmission": (m.transmission[0], min(1.0, m.transmission[1] * 1.01), m.transmission[2])}
        ),
    ),
    _tracer_misread(
        "thin_glass", P.ABSORPTION, "half of the way is absorbed", misread.glass(misread.with_absorption(0.5))
    ),
    _in_tracer("white_bands", P.DISPERSION, "every band is white, so the spectrum has no colours", _white_bands),
    _in_tracer("lost_photons", P.CAUSTIC, "the photon pass is skipped", _lose_photons),
    _tracer_misread(
        "leaky_glass",
        P.REFRACTION,
        "1 % of the flux is lost in clear glass",
        misread.glass(
            lambda m: {"transmission": (0.995,) * 3} if m.transmission == (1.0, 1.0, 1.0) and not m.fresnel else {}
        ),
    ),
)

MUTANTS: tuple[Mutant, ...] = (*TRANSLATOR, *TRACER)
