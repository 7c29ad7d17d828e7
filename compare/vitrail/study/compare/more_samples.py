"""Buy more samples where a verdict is in doubt, and nowhere else.

The interval of a number shrinks with the square root of the samples, so each doubtful comparison says how many times
the samples would decide it. A look at the numbers is a test: the runs that may follow count as comparisons too, and the
false-alarm rate of the suite holds whatever the number of looks.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vitrail.judge.comparison import Verdict
from vitrail.judge.records import SceneResult

MOST_AT_ONCE = 16.0
"""A round costs at most this many times the one before; a larger wish is met in several rounds or not at all."""

SAFETY = 1.3
"""The factor comes from an estimated interval, good to about 15 %; a little more spares another round."""


def wanted_factor(scene: SceneResult) -> float | None:
    """How many times the samples this scene should have next; None where it is decided or samples cannot decide."""
    if scene.verdict is not Verdict.INCONCLUSIVE:
        return None
    factors = [
        comparison.sample_factor
        for observation in scene.observations
        for comparison in observation.comparisons
        if comparison.verdict is Verdict.INCONCLUSIVE and comparison.sample_factor is not None
    ]
    return min(max(SAFETY * max(factors), 2.0), MOST_AT_ONCE) if factors else None


def more(settings: Mapping[str, Any], factor: float, *, fixed_samples: bool = False) -> dict[str, object]:
    """The settings to replace for ``factor`` times the work of both kinds; samples that the scene fixes stay."""
    keys = ("photons",) if fixed_samples else ("samples", "photons")
    return {key: round(settings[key] * factor) for key in keys if settings.get(key)}
