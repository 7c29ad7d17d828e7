"""Look for the whereabouts of a deviation: render the scene again with one thing after the other switched off.

Only a scene in which the engines deviate from each other is ablated, with the settings of its last run, and only as far
as its budget goes. A defect that is injected is injected into the ablated scene too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.progress import Progress, silent
from vitrail.base.record import number_in
from vitrail.engines.base import EngineFailure
from vitrail.geometry.world import World
from vitrail.images.exr import ImageError, ImageLayers, read_image
from vitrail.judge.comparison import Cause, ObservationResult, Pair, Verdict
from vitrail.judge.judgement import Residual, judge_observation
from vitrail.judge.observe import NothingToMeasure, Observed, observe, patch_lights
from vitrail.judge.patch_light import PatchLight
from vitrail.judge.records import SceneResult
from vitrail.judge.references import SceneTruth, read_scene_truth
from vitrail.judge.shown import Shown
from vitrail.judge.thresholds import Thresholds
from vitrail.judge.whereabouts import Switched, whereabouts
from vitrail.lower.povray import NothingToEdit, NotTranslatable
from vitrail.metrics.measurement import MetricError
from vitrail.pipeline.defect import Defect
from vitrail.pipeline.gated_views import read_views
from vitrail.pipeline.job import Job
from vitrail.pipeline.lowered import Lowered, job_of, lower
from vitrail.pipeline.request import Request
from vitrail.pipeline.run_both import run_both
from vitrail.plan.ablation import Ablation, ablations
from vitrail.plan.analyse import analyse
from vitrail.scene.load import Loaded
from vitrail.scene.model import Scene


@dataclass(frozen=True)
class AblatedScene:
    """The numbers of a scene with something off, by observation; none, with the reason, where it was not rendered."""

    ablation: Ablation
    observed: Mapping[str, Observed]
    light: Mapping[str, PatchLight]
    residual: Residual = lambda phenomenon, whole_over_light: 0.0
    cpu_s: float = 0.0
    reason: str = ""


@dataclass(frozen=True)
class Search:
    """What was tried for one scene. ``light`` is that of the scene itself, ``required`` what its plan requires."""

    ablated: tuple[AblatedScene, ...] = ()
    light: Mapping[str, PatchLight] = field(default_factory=dict)
    required: frozenset[Phenomenon] = frozenset()


def deviates_between_engines(observation: ObservationResult) -> bool:
    """Whether the engines deviate from each other by more than rounding."""
    return any(
        entry.pair is Pair.TRACER_POVRAY
        and entry.verdict is Verdict.DEVIATES
        and entry.attribution is not None
        and entry.attribution.cause is Cause.MODEL
        for entry in observation.comparisons
    )


def with_whereabouts(
    results: Sequence[ObservationResult], search: Search, thresholds: Thresholds, level: float
) -> tuple[ObservationResult, ...]:
    """The observations of a scene, each that deviates between the engines with where and why."""
    return tuple(
        changed(
            entry, where=whereabouts(entry, light, _switched(entry, search, thresholds, level), search.required, level)
        )
        if (light := search.light.get(entry.name)) is not None and deviates_between_engines(entry)
        else entry
        for entry in results
    )


def _switched(entry: ObservationResult, search: Search, thresholds: Thresholds, level: float) -> list[Switched]:
    """What every ablated scene says of one observation, judged by the same rules."""
    found = []
    for scene in search.ablated:
        own, observed = scene.ablation, scene.observed.get(entry.name)
        after = None if observed is None else judge_observation(observed, thresholds, scene.residual, level)
        light = scene.light.get(entry.name)
        found.append(Switched(own.name, own.words, own.absent, own.touched, own.darkens, after, light, scene.reason))
    return found


def search_whereabouts(
    loaded: Loaded,
    references: Path,
    record: SceneResult,
    request: Request,
    left_s: float,
    progress: Progress = silent,
    *,
    everywhere: bool = False,
) -> Search:
    """Every ablation of a judged scene that ``left_s`` CPU seconds pay for, priced by what the scene itself took.

    Measured is what deviates between the engines, or ``everywhere``.
    """
    world = World.of(loaded)
    scene, plan = world.scene, analyse(world)
    request = _with_settings_of(record, request)
    wanted = {entry.name for entry in record.observations if everywhere or deviates_between_engines(entry)}
    known = read_scene_truth(references, loaded.path.stem, scene)
    # The same places are measured in the same way; what they should give by formula is another matter now.
    truth = replace(known, truths={}, profiles={})
    own = {image.side: read_image(request.out / image.exr) for image in record.images if image.side != "stored"}
    radius_m = number_in(record.settings, "gather_radius_m", 0.0)
    views = {
        entry.name: Shown.of_record(entry.view, request.out) for entry in record.observations if entry.view is not None
    }
    light = patch_lights(scene, own, truth, radius_m, views)
    price_s = sum(engine.cpu_s or 0.0 for engine in record.engines)
    ablated = []
    for ablation in ablations(world, plan):
        if price_s > left_s:
            reason = f"about {price_s:.2g} CPU s each, and {max(left_s, 0):.2g} are left; --budget-s bounds it"
            ablated.append(AblatedScene(ablation, {}, {}, reason=reason))
            continue
        place = request.out / record.name / "ablated"
        tried = _ablated(loaded, ablation, truth, wanted, request, place, progress)
        left_s -= tried.cpu_s
        ablated.append(tried)
    required = frozenset(phenomenon for phenomenon in Phenomenon if plan.requires(phenomenon))
    return Search(tuple(ablated), light, required)


def _ablated(
    loaded: Loaded,
    ablation: Ablation,
    truth: SceneTruth,
    wanted: set[str],
    request: Request,
    place: Path,
    progress: Progress,
) -> AblatedScene:
    """Render and measure one ablated scene; what goes wrong is said and ends nothing."""
    scene = _observing(ablation.scene, wanted)
    job = job_of(replace(loaded, scene=scene), request)
    folder = place / ablation.name.replace(" ", "_")
    try:
        lowered = _lowered(job, request)
        made = run_both(lowered, folder, request, progress)
        cpu_s = sum(rendering.record.get("cpu_s", {}).get("total") or 0.0 for rendering in made.values())
        images = {side: read_image(rendering.image_path) for side, rendering in made.items()}
        views, radius_m = read_views(job.views, made), job.settings.gather_radius_m
        observed = _observed(job.scene, images, truth, radius_m, views)
        light = patch_lights(job.scene, images, truth, radius_m, views)
    except (NotTranslatable, EngineFailure, ImageError, NothingToMeasure, MetricError) as error:
        # The first clause says what went wrong; remedies are for a scene that somebody wrote.
        return AblatedScene(ablation, {}, {}, reason=" ".join(str(error).split()).split(";")[0])
    return AblatedScene(ablation, observed, light, lowered.certificate.bound, cpu_s)


def _lowered(job: Job, request: Request) -> Lowered:
    """An ablated scene for both engines; a defect whose nodes the ablation took away has gone with them."""
    try:
        return lower(job, request)
    except NothingToEdit:
        harmless = replace(request.defect, povray=Defect().povray)
        return lower(job, replace(request, defect=harmless))


def _with_settings_of(record: SceneResult, request: Request) -> Request:
    """As many samples and photons as the scene had, and nothing but the two engines against each other."""
    same = {key: record.settings[key] for key in ("samples", "photons", "seed") if record.settings.get(key)}
    return replace(request, overrides={**same, **request.overrides}, against=("povray",))


def _observing(scene: Scene, wanted: set[str]) -> Scene:
    return changed(scene, observe=tuple(entry for entry in scene.observe if entry.name in wanted))


def _observed(
    scene: Scene,
    images: Mapping[str, ImageLayers],
    truth: SceneTruth,
    radius_m: float,
    views: Mapping[str, Shown],
) -> dict[str, Observed]:
    found = observe(scene, images, (Pair.TRACER_POVRAY,), truth, radius_m, views)
    return {entry.observation.name: entry for entry in found}
