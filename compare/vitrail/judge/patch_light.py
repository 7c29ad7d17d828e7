"""The mean light of one patch in both engines, and what each of the tracer's layers gives to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.judge.comparison import LayerShare
from vitrail.metrics.measurement import CHANNELS, Context, Interval, Measurement
from vitrail.metrics.noise import with_interval
from vitrail.metrics.radiance import mean_difference, patch_mean
from vitrail.scene.phenomenon import Phenomenon

TOO_WEAK = 1.25
"""An excess above all of a layer by a quarter: rounding and the tolerances of both engines are far below that."""


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

    def difference(self, channel: int, level: float) -> Interval | None:
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
    """The share of each layer that gives light; and, where the mean light deviates, how wrong it would have to be.

    Of an excess of the tracer the surest part is taken, the end of its interval that is nearest to zero. Light that
    POV-Ray has more of says nothing about the tracer's layers: a layer can be too strong there by any factor.
    """
    channel, total = light.worst, float(light.tracer[light.worst])
    if total <= 0:
        return ()
    interval = light.difference(channel, level)
    excess = max(interval.low, 0.0) if interval is not None and mean_deviates else 0.0
    return tuple(
        LayerShare(
            layer=layer,
            channel=CHANNELS[channel],
            share=float(values[channel]) / total,
            needed=excess / max(float(values[channel]), 1e-12 * total) if excess > 0 else None,
        )
        for layer, values in light.layers.items()
    )


def is_too_weak(layer: LayerShare) -> bool:
    """Whether the tracer's excess is more than all that a layer gives; diffusion is what every layer falls on."""
    return layer.needed is not None and layer.needed > TOO_WEAK and layer.layer is not Phenomenon.DIFFUSION
