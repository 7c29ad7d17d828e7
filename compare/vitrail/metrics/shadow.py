"""The edge of a shadow: where it is, how wide its penumbra is, how dark it is behind it."""

from __future__ import annotations

from vitrail.images.patch import PatchSamples
from vitrail.metrics.edge import Ramp, measure_ramp
from vitrail.metrics.measurement import Context, Measurement, MetricError
from vitrail.metrics.profile import cell_m, profile


def penumbra(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """The edge of a shadow along ``context.along``, from the profile itself and no model of its shape.

    Absolute: ``penumbra_width`` (10 to 90 % of the step, metres), ``shadow_edge`` (50 %, metres from the patch centre),
    ``shadow_depth`` (dark side over lit side). Comparison: ``penumbra_difference`` in metres and
    ``shadow_edge_shift``, ideal 0, and ``shadow_depth_shift``, ideal 0. The average over a cell of width h widens a
    sharp edge to 0.8 h; ``parts`` holds h.
    """
    ours = _ramp(candidate, context)
    settings = {"along": context.along, "levels": (0.1, 0.5, 0.9)}
    parts = {"cell_m": cell_m(candidate, context.along), "before": ours.before, "after": ours.after}
    if reference is None:
        return [
            Measurement("penumbra_width", ours.width_m, "m", None, settings, parts),
            Measurement("shadow_edge", ours.x50_m, "m", None, settings, parts),
            Measurement("shadow_depth", _depth(ours), "1", None, settings, parts),
        ]
    theirs = _ramp(reference, context)
    widths = {**parts, "candidate": ours.width_m, "reference": theirs.width_m}
    return [
        Measurement("penumbra_difference", ours.width_m - theirs.width_m, "m", 0.0, settings, widths),
        Measurement("shadow_edge_shift", ours.x50_m - theirs.x50_m, "m", 0.0, settings, parts),
        Measurement("shadow_depth_shift", _depth(ours) - _depth(theirs), "1", 0.0, settings, parts),
    ]


def _ramp(samples: PatchSamples, context: Context) -> Ramp:
    x, channels = profile(samples.values, samples, context.along)
    return measure_ramp(x, channels.mean(axis=-1))


def _depth(ramp: Ramp) -> float:
    lit, dark = max(ramp.before, ramp.after), min(ramp.before, ramp.after)
    if not lit > 0:
        raise MetricError("both sides of the edge are black; there is no shadow to measure")
    return dark / lit
