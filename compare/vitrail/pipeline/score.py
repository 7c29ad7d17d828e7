"""Finished images of a scene, from whatever programs made them: the same gates, numbers and verdicts.

They are the scene's own picture, or views of its observations, or both; where there are views they are measured.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.images.exr import ImageLayers, read_image
from vitrail.judge.comparison import Pair
from vitrail.judge.gates import check_gates, gate_same_exposure
from vitrail.judge.observe import NothingToMeasure, observe
from vitrail.judge.pictures import write_pictures
from vitrail.judge.records import EngineRun, Results, SceneResult, Status, write_results
from vitrail.judge.references import read_scene_truth, references_folder
from vitrail.judge.shown import Shown
from vitrail.judge.thresholds import own_references
from vitrail.judge.whole_image import global_metrics
from vitrail.pipeline.about_run import about_run
from vitrail.pipeline.conformance import (
    behind_gate,
    conformance_scenes,
    failure_of,
    proof_images,
    why_unproven,
)
from vitrail.pipeline.foreign_views import foreign_views
from vitrail.pipeline.gated_images import inspect
from vitrail.pipeline.job import prepare
from vitrail.pipeline.judge import judge
from vitrail.pipeline.record_parts import plan_records
from vitrail.pipeline.scene_record import ended, record_of_scene
from vitrail.pipeline.scene_run import SceneRun
from vitrail.scene.load import Loaded

REMEDY = "render scenes/conformance/*.yaml with it and give --conformance FOLDER, or say --unproven"
NOTHING_KNOWN = "there is nothing to hold the image against: no closed form is known here; give a REFERENCE.exr"
PAIRS = (Pair.CANDIDATE_REFERENCE, Pair.CANDIDATE_TRUTH, Pair.REFERENCE_TRUTH)


Images = Mapping[str, ImageLayers]
"""Images of one picture, by side."""


@dataclass(frozen=True)
class _Given:
    """What somebody wants judged: the scene's own picture by side, and folders of views by side."""

    loaded: Loaded
    files: Mapping[str, Path]
    views: Mapping[str, Path]

    def again(self, options: Sequence[str]) -> str:
        """The line that judges it again."""
        flags = {"candidate": "--views", "reference": "--reference-views"}
        named = [word for side, folder in self.views.items() for word in (flags[side], str(folder))]
        words = ["vitrail score", str(self.loaded.path), *map(str, self.files.values()), *named, *options]
        return " ".join([*words, "--out out"])


def score(
    loaded: Loaded,
    files: Mapping[str, Path],
    out: Path,
    *,
    views: Mapping[str, Path] | None = None,
    references: Path | None = None,
    conformance: Path | None = None,
    needs_proof: bool = False,
    command: tuple[str, ...] = (),
) -> Results:
    """Judge ``files`` by side and write ``results.json``. Raises ImageError and ReferencesError.

    ``views`` are folders by side with the pictures that ``emit views`` asks for.
    ``conformance`` is a folder with the renderer's images of the conformance scenes: they are judged first and by
    themselves, and stand in the results before the scene. With ``needs_proof`` a foreign image without them is refused.
    """
    given = _Given(loaded, files, views or {})
    proofs = [] if conformance is None else _proofs(conformance, out)
    options = ["--conformance", str(conformance)] if conformance else [] if needs_proof else ["--unproven"]
    run, makers = _measured(given, out, references, options)
    unproven = next(filter(None, (why_unproven(loaded, images) for images in makers)), "")
    if proofs:
        run = behind_gate(run, failure_of(judge(proofs, about_run(()))))
    elif unproven and needs_proof:
        run = behind_gate(run, f"{unproven}; {REMEDY}")
    elif unproven:
        run = replace(run, record=changed(run.record, warnings=(*run.record.warnings, unproven)))
    results = judge([*proofs, run], about_run(command))
    out.mkdir(parents=True, exist_ok=True)
    write_results(results, out / "results.json")
    return results


def _proofs(folder: Path, out: Path) -> list[SceneRun]:
    """The renderer's images of the conformance scenes, each against its closed forms."""
    paths, runs = proof_images(folder), []
    for scene in conformance_scenes():
        given = _Given(scene, {"candidate": paths[scene.path.stem]}, {})
        runs.append(_measured(given, out, own_references())[0])
    return runs


def _measured(
    given: _Given, out: Path, references: Path | None, options: Sequence[str] = ()
) -> tuple[SceneRun, list[Images]]:
    """Gates first; then pictures, whole-image numbers and observations. Also all images, each with its header."""
    loaded, scene, name = given.loaded, given.loaded.scene, given.loaded.path.stem
    images: Images = {side: read_image(path) for side, path in given.files.items()}
    job = prepare(loaded)
    record = record_of_scene(loaded, name, given.again(options))
    record = changed(record, plan=plan_records(job.plan))
    record = _gated(record, images, given.files)
    if record.status is not Status.JUDGED:
        return SceneRun(record), [images]
    shown: dict[str, Shown] = {}
    if given.views:
        record, shown = foreign_views(job, record, given.views, out / name)
    all_images = [images, *(each.images for each in shown.values())]
    record = changed(record, engines=_makers(all_images))
    if record.status is not Status.JUDGED:
        return SceneRun(record), all_images
    if images:
        record = _pictured(record, images, given.files, out / name)
    folder = references_folder(loaded.path, references)
    truth = read_scene_truth(folder, name, scene)
    radius_m = max(_gather_radius_m(image) for each in all_images for image in each.values())
    try:
        observed = observe(scene, images, PAIRS, truth, radius_m, shown)
    except NothingToMeasure as nothing:
        return SceneRun(ended(record, Status.SCENE_ERROR, str(nothing))), all_images
    if not any(each.measured or each.unmeasured for each in observed):
        return SceneRun(ended(record, Status.SCENE_ERROR, NOTHING_KNOWN)), all_images
    return SceneRun(record, observed, references=folder), all_images


def _gated(record: SceneResult, images: Images, files: Mapping[str, Path]) -> SceneResult:
    """What the gates say of the scene's own picture, by whoever made it; a closed one ends the record."""
    inspected = [inspect(side, image, str(files[side])) for side, image in images.items()]
    gates = check_gates(record.width, record.height, record.scene_hash, inspected)
    gates += tuple(gate_same_exposure(*pair) for pair in pairwise(inspected))
    record = changed(record, gates=gates)
    failed = [gate.message for gate in gates if not gate.passed]
    return ended(record, Status.GATE_FAILED, "\n".join(failed)) if failed else record


def _pictured(record: SceneResult, images: Images, files: Mapping[str, Path], place: Path) -> SceneResult:
    """The record with copies of the scene's own pictures in ``place``, and the numbers of the whole of them."""
    place.mkdir(parents=True, exist_ok=True)
    kept = {side: _kept(path, place / f"{side}.exr") for side, path in files.items()}
    sides, differences = write_pictures(images, kept, place, record.exposure_stops)
    whole = global_metrics(Pair.CANDIDATE_REFERENCE, images, record.exposure_stops)
    return changed(record, images=sides, differences=differences, global_metrics=whole)


def _makers(all_images: Sequence[Images]) -> tuple[EngineRun, ...]:
    """Who made each side, by the first of its images."""
    found = {side: _maker(side, image) for images in reversed(all_images) for side, image in images.items()}
    return tuple(found[side] for side in ("candidate", "reference") if side in found)


def _maker(side: str, image: ImageLayers) -> EngineRun:
    """Who made an image, if its header says."""
    return EngineRun(engine=side, version=str(image.metadata.get("vitrail:engine", "not stated")))


def _kept(source: Path, target: Path) -> Path:
    """A copy beside the results, so that the folder shows the same images for ever."""
    if source.resolve() != target.resolve():
        shutil.copy2(source, target)
    return target


def _gather_radius_m(image: ImageLayers) -> float:
    """The photon kernel that an image says it was made with; it is how far its noise is correlated."""
    try:
        found = json.loads(str(image.metadata.get("vitrail:settings", "{}"))).get("gather_radius_m", 0.0)
    except (json.JSONDecodeError, AttributeError):
        return 0.0
    return float(found) if isinstance(found, int | float) and found > 0 else 0.0
