"""The certificate of a translation: one entry for every law that POV-Ray follows differently."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from vitrail.lower.povray.certificate import RELATIVE, Certificate, Entry
from vitrail.lower.povray.depth import TraceDepth
from vitrail.lower.povray.lights import FADE_SHARE, Source
from vitrail.lower.povray.modes import Mode
from vitrail.lower.povray.normalise import Normalisation
from vitrail.lower.povray.photons import PhotonPass
from vitrail.plan.plan import Plan
from vitrail.scene.model import Scene
from vitrail.scene.phenomenon import Phenomenon

HALF_FLOAT = 4.9e-4
"""Largest relative rounding of an 11-bit mantissa, half a step at the low end [P 6]."""


def certificate_of(
    scene: Scene,
    plan: Plan,
    mode: Mode,
    units: Normalisation,
    lights: Sequence[Source],
    photons: PhotonPass | None,
    depth: TraceDepth,
) -> Certificate:
    """Everything that differs, most general first."""
    found = [
        *_output(plan),
        *_falloff(plan, lights),
    ]
    return Certificate(tuple(found))


def _output(plan: Plan) -> Iterator[Entry]:
    for phenomenon in Phenomenon:
        if plan.requires(phenomenon):
            yield Entry(
                phenomenon,
                "image",
                "radiance in double precision",
                "half-float image",
                HALF_FLOAT,
                RELATIVE,
                "POV-Ray's linear output has 11 bits a channel",
            )


def _falloff(plan: Plan, lights: Sequence[Source]) -> Iterator[Entry]:
    for index, source in enumerate(lights, 1):
        if source.fade_distance is not None:
            yield Entry(
                Phenomenon.DIFFUSION,
                f"L{index}",
                "E = I / r^2",
                "E = I / (r^2 + f^2)",
                FADE_SHARE**2,
                RELATIVE,
                "POV-Ray has no unbounded inverse square; f is 1/1000 of the nearest surface's distance",
            )
