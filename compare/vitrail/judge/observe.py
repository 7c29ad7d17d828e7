"""Measure every observation of a scene on every pair of images and against every known truth; judge nothing yet.

The verdict waits, because the level of an interval depends on how many comparisons the whole run makes.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from vitrail.base.phenomenon import Phenomenon
from vitrail.images.exr import ImageLayers
from vitrail.images.patch import PatchSamples
from vitrail.judge.comparison import Pair, PatchRecord, Profile
from vitrail.judge.lost_light import LostLight
from vitrail.judge.noise_record import NoiseRecord, noise_records
from vitrail.judge.patch_light import PatchLight, patch_light
from vitrail.judge.profiles import profiles_of
from vitrail.judge.references import SceneTruth, Truth
from vitrail.judge.shown import Shown, patch_record
from vitrail.judge.to_json import to_json
from vitrail.judge.verdict import Measured, Noise
from vitrail.judge.view_record import ViewRecord
from vitrail.metrics.by_phenomenon import measure, measure_with_intervals
from vitrail.metrics.measurement import Context, Measurement, MetricError
from vitrail.metrics.smoothing import smoothed_again
from vitrail.scene.model import Observation, Scene

UNSEEN = 0.5
"""Below this share of a patch in the frame, its numbers are about something else than the scene says."""


@dataclass(frozen=True)
class Observed:
    """One observation with its numbers; ``unmeasured`` says what no number could be had for.

    ``view`` is the picture in which it was measured, None for the scene's own; ``noise`` is what its noise comes from,
    ``lost`` the light that no engine shows there.
    """

    observation: Observation
    patch: PatchRecord
    half_edge_m: float
    measured: tuple[Measured, ...]
    truths: tuple[Truth | None, ...]
    profiles: tuple[Profile, ...]
    unmeasured: tuple[str, ...]
    view: ViewRecord | None = None
    noise: tuple[NoiseRecord, ...] = ()
    lost: LostLight = LostLight()


def merged(first: Observed, second: Observed) -> Observed:
    """The numbers of two looks at one observation; the patch and the profiles are those of the first."""
    return replace(
        first,
        measured=first.measured + second.measured,
        truths=first.truths + second.truths,
        unmeasured=tuple(dict.fromkeys(first.unmeasured + second.unmeasured)),
    )


class NothingToMeasure(Exception):
    """A patch is outside the frame or empty; the message names the observation and the remedy."""


def observe(
    scene: Scene,
    images: Mapping[str, ImageLayers],
    pairs: Sequence[Pair],
    truth: SceneTruth,
    correlation_m: float,
    views: Mapping[str, Shown] | None = None,
    only: frozenset[str] | None = None,
) -> tuple[Observed, ...]:
    """Everything the scene asks to be observed, or those observations ``only``.

    ``images`` by side are the scene's own; ``views`` by observation are what was made for it alone. ``correlation_m``
    is the gather radius. Raises NothingToMeasure for a patch that shows nothing.
    """
    own = Shown.by_scene(scene, images)
    return tuple(
        _observe(scene, entry, (views or {}).get(entry.name, own), pairs, truth, correlation_m)
        for entry in scene.observe
        if only is None or entry.name in only
    )


def _observe(
    scene: Scene,
    observation: Observation,
    shown: Shown,
    pairs: Sequence[Pair],
    truth: SceneTruth,
    correlation_m: float,
) -> Observed:
    """One observation: sample the patch of every image, compare every pair, hold every side against its truths."""
    grid = shown.grid(observation.patch)
    if grid.coverage.mean() < UNSEEN:
        share = f"{100 * grid.coverage.mean():.0f} %"
        raise NothingToMeasure(
            f"{observation.name}: {share} of its patch is in the frame; move the patch or the camera"
        )
    samples = {side: shown.samples(side, observation.patch, grid) for side in shown.images}
    context = context_of(scene, observation, truth, correlation_m)
    measured: list[Measured] = []
    truths: list[Truth | None] = []
    unmeasured: list[str] = []
    for pair in pairs:
        if pair.candidate in samples and pair.reference in samples:
            found, silent = _compare(pair, observation, samples, context)
            measured += found
            truths += [None] * len(found)
            unmeasured += silent
        elif pair.candidate in samples and pair.reference == "truth":
            known = truth.of(observation.name)
            found, kept, silent = _against(pair, known, observation, samples[pair.candidate], context)
            measured += found
            truths += kept
            unmeasured += silent
    return Observed(
        observation=observation,
        patch=patch_record(scene, observation.patch, grid),
        half_edge_m=min(math.hypot(*observation.patch.u), math.hypot(*observation.patch.v)),
        measured=tuple(measured),
        truths=tuple(truths),
        profiles=profiles_of(observation, samples, truth.profiles.get(observation.name)),
        unmeasured=tuple(dict.fromkeys(unmeasured)),
        view=shown.record,
        noise=noise_records(samples, scene, correlation_m),
        lost=shown.lost,
    )


def patch_lights(
    scene: Scene,
    images: Mapping[str, ImageLayers],
    truth: SceneTruth,
    correlation_m: float,
    views: Mapping[str, Shown] | None = None,
) -> dict[str, PatchLight]:
    """The mean light of every patch in both engines. Raises MetricError for a patch outside the image."""
    found, own = {}, Shown.by_scene(scene, images)
    for entry in scene.observe:
        shown = (views or {}).get(entry.name, own)
        grid = shown.grid(entry.patch)
        tracer, povray = (shown.samples(side, entry.patch, grid) for side in ("tracer", "povray"))
        found[entry.name] = patch_light(tracer, povray, context_of(scene, entry, truth, correlation_m))
    return found


def context_of(scene: Scene, observation: Observation, truth: SceneTruth, correlation_m: float) -> Context:
    """What the metrics may know: what the references state of the observation, and what the camera and plan give."""
    view = math.dist(scene.camera.position, observation.patch.center)
    known = truth.context(observation.name)
    return replace(
        known,
        along=observation.along or known.along,
        view_distance_m=known.view_distance_m or view,
        correlation_m=correlation_m,
    )


def _compare(
    pair: Pair, observation: Observation, samples: Mapping[str, PatchSamples], context: Context
) -> tuple[list[Measured], list[str]]:
    """Every metric of the phenomenon between two images."""
    try:
        found = measure_with_intervals(
            observation.phenomenon, samples[pair.candidate], samples[pair.reference], context
        )
    except MetricError as error:
        return [], [f"{pair.value}: {error}"]
    compared = [entry for entry in found if entry.ideal is not None]
    steady, silent = _steady(pair, compared, (samples[pair.candidate], samples[pair.reference]))
    return [_measured(pair, entry, float(entry.ideal or 0.0), "") for entry in steady], silent


def _steady(
    pair: Pair, found: Sequence[Measurement], samples: Sequence[PatchSamples]
) -> tuple[list[Measurement], list[str]]:
    """The numbers that a little more noise leaves there, and words about the others: those have no interval."""
    if all(each.noise is None for each in samples):
        return list(found), []
    steady = [entry for entry in found if entry.interval is not None]
    lost = [f"{pair.value}: {entry.metric} comes and goes with the noise" for entry in found if entry.interval is None]
    return steady, lost


def _against(
    pair: Pair, truths: Sequence[Truth], observation: Observation, samples: PatchSamples, context: Context
) -> tuple[list[Measured], list[Truth], list[str]]:
    """Measured quantities against their closed forms; one that the metrics do not give is said, not dropped."""
    if not truths:
        return [], [], []
    try:
        measured = measure_with_intervals(observation.phenomenon, samples, None, context)
    except MetricError as error:
        return [], [], [f"{pair.value}: {error}"]
    wanted = {truth.metric for truth in truths}
    steady, lost = _steady(pair, [entry for entry in measured if entry.metric in wanted], (samples,))
    found = {entry.metric: entry for entry in steady}
    known = {entry.metric for entry in measured}
    smoothing = _smoothing(observation, samples, found, context)
    kept = [truth for truth in truths if truth.metric in found]
    absent = [truth.metric for truth in truths if truth.metric not in known]
    return (
        [
            _measured(pair, found[truth.metric], truth.value, truth.origin, smoothing.get(truth.metric, 0.0))
            for truth in kept
        ],
        kept,
        [*lost, *(f"{pair.value}: the metrics of {observation.phenomenon} give no {metric}" for metric in absent)],
    )


def _smoothing(
    observation: Observation, samples: PatchSamples, found: Mapping[str, Measurement], context: Context
) -> dict[str, float]:
    """How far disc, pixel and cell move each number of a caustic from its closed form, by metric."""
    if observation.phenomenon is not Phenomenon.CAUSTIC:
        return {}
    try:
        again = measure(observation.phenomenon, smoothed_again(samples, context.correlation_m), None, context)
    except MetricError:
        return {}
    return {each.metric: abs(each.value - found[each.metric].value) for each in again if each.metric in found}


def _measured(pair: Pair, entry: Measurement, ideal: float, source: str, smoothing: float = 0.0) -> Measured:
    """A measurement as the judge takes it; unknown noise (no half images) is taken as none, with a caveat."""
    interval = entry.interval
    if interval is None or interval.standard_error == 0:
        noise = Noise(0.0)
    else:
        noise = Noise(interval.standard_error, interval.degrees_of_freedom, interval.method)
    caveats = entry.caveats if interval is not None or entry.caveats else ("its noise is not known",)
    return Measured(
        pair=pair,
        metric=entry.metric,
        unit=entry.unit,
        value=float(entry.value),
        ideal=float(ideal),
        noise=noise,
        ideal_source=source,
        settings=to_json(entry.settings),
        parts=to_json(entry.parts),
        caveats=caveats,
        smoothing=smoothing,
    )
