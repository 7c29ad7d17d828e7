"""Known mistakes to put into a translation on purpose: each must turn its phenomenon red, or the harness is blind.

These are the three that every run of the tests injects. A defect works on the finished scene text, as the mistake of a
translator would, and on how the images of the runs are added up.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import fields, replace

from vitrail.lower.povray import PovrayRun, PovrayScene
from vitrail.lower.povray.text.sdl import number, rgb
from vitrail.pipeline.request import Defect

LIGHT = re.compile(r"(light_source \{ <[^>]*> )rgb (<[^>]*>|[-+.\deE]+)")
ABSORBING = re.compile(r"media \{ absorption rgb (<[^>]*>|[-+.\deE]+) \}")

SPACING = re.compile(r"spacing ([-+.\deE]+)")
PARALLEL = re.compile(r"rgb <([-+.\deE]+), [^>]*> parallel")

BRIGHTER = 256.0
"""More light with less gain leaves the picture as it is; more than this could overflow the half floats of the image."""

TOO_MUCH_FLUX = 64.0
"""POV-Ray drops photons of flux 32 and more without a word [P 2.4]."""


def on_text(change: Callable[[str], str]) -> Callable[[PovrayScene], PovrayScene]:
    """A change of every scene text of every run."""

    def apply(scene: PovrayScene) -> PovrayScene:
        return replace(scene, runs=tuple(_changed(run, change) for run in scene.runs))

    return apply


def _changed(run: PovrayRun, change: Callable[[str], str]) -> PovrayRun:
    """A run has one text or two (photons are shot in one of their own); all begin with the language's version."""
    texts = {
        each.name: change(value)
        for each in fields(run)
        if isinstance(value := getattr(run, each.name), str) and value.startswith("#version")
    }
    return replace(run, **texts)  # type: ignore[arg-type]


def brighter_lights(factor: float) -> Callable[[str], str]:
    """Multiply the colour of every light."""

    def change(text: str) -> str:
        return LIGHT.sub(lambda found: f"{found[1]}rgb {_scaled(found[2], factor)}", text)

    return change


def naive_fade(text: str) -> str:
    """Paste colour and distance of the attenuation into a fade, which wants one minus the coefficient.

    The colour is stated where a tenth of the strongest channel is left, as an author of a material would.
    """

    def change(found: re.Match[str]) -> str:
        coefficients = _numbers(found[1])
        distance = math.log(10) / max(coefficients)
        red, green, blue = (math.exp(-each * distance) for each in coefficients)
        return f"fade_distance {number(distance)} fade_power 1001 fade_color {rgb((red, green, blue))}"

    return ABSORBING.sub(change, text)


def _overflow(scene: PovrayScene) -> PovrayScene:
    """Fewer photons of more light: the picture keeps its brightness, but photons no longer fit their number format."""
    if all(run.photon_sdl is None for run in scene.runs):
        return scene
    brighter = on_text(lambda text: sparse_photons(brighter_lights(BRIGHTER)(text)))(scene)
    runs = tuple(replace(run, gain=tuple(each / BRIGHTER for each in run.gain)) for run in brighter.runs)  # type: ignore[arg-type]
    return replace(brighter, runs=runs)


def sparse_photons(text: str) -> str:
    """Widen the spacing until a photon of the brightest parallel light carries too much."""
    found = SPACING.search(text)
    if found is None:
        return text
    spacing = float(found[1])
    colours = [float(each) for each in PARALLEL.findall(text)]
    # The flux of a lamp's photon depends on its distance too; a factor of 32 in spacing outdoes any sensible choice.
    wider = math.sqrt(TOO_MUCH_FLUX / (max(colours) * spacing**2)) if colours else 32.0
    return SPACING.sub(f"spacing {number(spacing * max(wider, 1.0))}", text)


def _numbers(text: str) -> list[float]:
    """``<1, 2, 3>`` or ``1`` as three numbers."""
    found = [float(each) for each in text.strip("<>").split(",")]
    return found * 3 if len(found) == 1 else found


def _scaled(text: str, factor: float) -> str:
    red, green, blue = (each * factor for each in _numbers(text))
    return f"<{number(red)}, {number(green)}, {number(blue)}>"


DEFECTS: Mapping[str, Defect] = {
    defect.name: defect
    for defect in (
        Defect("missing_pi", povray=on_text(brighter_lights(math.pi))),
        Defect("naive_fade", povray=on_text(naive_fade)),
        Defect("photon_overflow", povray=_overflow),
    )
}
