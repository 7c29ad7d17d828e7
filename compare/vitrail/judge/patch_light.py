"""The mean light of one patch in both engines, and what each of the tracer's layers gives to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from vitrail.base.phenomenon import Phenomenon
from vitrail.images.patch import PatchSamples
from vitrail.judge.comparison import LayerShare
from vitrail.metrics.measurement import CHANNELS, Context, Measurement, StudentInterval
from vitrail.metrics.noise import with_interval
from vitrail.metrics.radiance import mean_difference, patch_mean

TOO_WEAK = 1.25
"""An excess above all of a light by a quarter: rounding and the tolerances of both engines are far below that."""

DARK = 1e-9
"""Share of the light that stands for none, so that no division is by zero."""

BENDING = (Phenomenon.REFLECTION, Phenomenon.REFRACTION, Phenomenon.TOTAL_INTERNAL_REFLECTION)
SPECULAR = (*BENDING, Phenomenon.CAUSTIC)
"""Layers of light that came by glass or mirror. What turns it at one face decides about all of them: a wrong index
moves the light of a caustic, and what Fresnel does not mirror he lets through."""


@dataclass(frozen=True)
class PatchLight:
    """``tracer``, ``povray``, ``layers``: mean radiance (3,), W sr^-1 m^-2; ``differences`` are tracer less POV-Ray."""

    tracer: np.ndarray
    povray: np.ndarray
    differences: tuple[Measurement, ...]
    layers: Mapping[Phenomenon, np.ndarray]

    @property
    def worst(self) -> int:
        """The channel in which the engines differ most."""
        return int(np.argmax(np.abs(self.tracer - self.povray)))

    @property
    def brightest(self) -> float:
        """The light of the brighter engine, mean of the channels."""
        return float(max(self.tracer.mean(), self.povray.mean()))

    def difference(self, channel: int, level: float) -> StudentInterval | None:
        """The interval of tracer less POV-Ray; None where noise is not known."""
        known = self.differences[channel].interval
        return None if known is None else known.at_level(level)


def patch_light(tracer: PatchSamples, povray: PatchSamples, context: Context) -> PatchLight:
    """Mean light with its noise. Raises MetricError for a patch outside the image."""
    layers = {
        Phenomenon(name): patch_mean(replace(tracer, values=layer, half_a=None, half_b=None, layers={}))
        for name, layer in tracer.layers.items()
        if name in set(Phenomenon)
    }
    differences = with_interval(mean_difference, tracer, povray, context)
    return PatchLight(patch_mean(tracer), patch_mean(povray), tuple(differences), layers)


def layer_shares(light: PatchLight, level: float, *, mean_deviates: bool) -> tuple[LayerShare, ...]:
    """The share of each layer, and where the mean light deviates, how wrong its phenomenon would have to be.

    Of an excess of the tracer the surest part is taken, the end of its interval that is nearest to zero. Light that
    POV-Ray has more of says nothing about the tracer's layers: a layer can be too strong there by any factor.
    """
    channel, total = light.worst, float(light.tracer[light.worst])
    if total <= 0:
        return ()
    interval = light.difference(channel, level)
    excess = max(interval.low, 0.0) / total if interval is not None and mean_deviates else 0.0
    shares = {layer: float(values[channel]) / total for layer, values in light.layers.items()}
    found = []
    for layer, share in shares.items():
        acts_on = sum(shares.get(each, 0.0) for each in SPECULAR) if layer in BENDING else share
        needed = excess / max(acts_on, DARK) if excess > 0 else None
        found.append(LayerShare(layer=layer, channel=CHANNELS[channel], share=share, acts_on=acts_on, needed=needed))
    return tuple(found)


def is_too_weak(layer: LayerShare) -> bool:
    """Whether the tracer's excess is more than all the light a phenomenon acts on; diffusion acts on all of it."""
    return layer.needed is not None and layer.needed > TOO_WEAK and layer.layer is not Phenomenon.DIFFUSION
