"""Which metrics belong to which phenomenon: the one list. A new metric is its file, its test, and one name here."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Protocol

from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import Axis, Context, Measurement
from vitrail.metrics.radiance import mean_radiance

PatchMetric = Callable[[PatchSamples, PatchSamples | None, Context], list[Measurement]]


class Observed(Protocol):
    """What is asked of an observation of the scene: its phenomenon and, if it has one, its direction."""

    @property
    def phenomenon(self) -> str: ...
    @property
    def along(self) -> Axis | None: ...


BY_PHENOMENON: Mapping[str, tuple[PatchMetric, ...]] = {
    "diffusion": (mean_radiance,),
    "reflection": (mean_radiance,),
    "refraction": (mean_radiance,),
    "total_internal_reflection": (mean_radiance,),
    "coloured_transmission": (mean_radiance,),
    "absorption": (mean_radiance,),
    "caustic": (mean_radiance,),
    "roughness": (mean_radiance,),
    "dispersion": (mean_radiance,),
    "shadow": (mean_radiance,),
    "indirect_light": (mean_radiance,),
}


def measure(
    observation: Observed, candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> list[Measurement]:
    """Everything the phenomenon of ``observation`` asks of the samples.

    Without a reference: absolute quantities of ``candidate``. With one: comparisons, each with its ideal.
    """
    known = context if observation.along is None else replace(context, along=observation.along)
    return [m for metric in BY_PHENOMENON[observation.phenomenon] for m in metric(candidate, reference, known)]
