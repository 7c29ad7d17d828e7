"""Two finished images of a scene, from whatever programs made them: the same gates, numbers and verdicts."""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.images.exr import ImageLayers, read_image
from vitrail.judge.comparison import Pair
from vitrail.judge.gates import check_gates, gate_same_exposure
from vitrail.judge.observe import NothingToMeasure, observe
from vitrail.judge.pictures import write_pictures
from vitrail.judge.records import EngineRun, Results, Status, write_results
from vitrail.judge.references import read_scene_truth, references_folder
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


def score(
    loaded: Loaded,
    files: Mapping[str, Path],
    out: Path,
    *,
    references: Path | None = None,
    conformance: Path | None = None,
    needs_proof: bool = False,
    command: tuple[str, ...] = (),
) -> Results:
    """Judge ``files`` by side and write ``results.json``. Raises ImageError and ReferencesError.

    ``conformance`` is a folder with the renderer's images of the conformance scenes: they are judged first and by
    themselves, and stand in the results before the scene. With ``needs_proof`` a foreign image without them is refused.
    """
    images = {side: read_image(path) for side, path in files.items()}
    proofs = [] if conformance is None else _proofs(conformance, out)
    options = ["--conformance", str(conformance)] if conformance else [] if needs_proof else ["--unproven"]
    run = _measured(loaded, images, files, out, references, options)
    unproven = why_unproven(loaded, images)
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
        files = {"candidate": paths[scene.path.stem]}
        runs.append(_measured(scene, {"candidate": read_image(files["candidate"])}, files, out, own_references()))
    return runs


def _measured(
    loaded: Loaded,
    images: Mapping[str, ImageLayers],
    files: Mapping[str, Path],
    out: Path,
    references: Path | None,
    options: Sequence[str] = (),
) -> SceneRun:
    """Gates first; then pictures, whole-image numbers and observations."""
    scene, name = loaded.scene, loaded.path.stem
    again = " ".join(["vitrail score", str(loaded.path), *map(str, files.values()), *options, "--out out"])
    makers = tuple(_maker(side, image) for side, image in images.items())
    record = record_of_scene(loaded, name, again)
    record = changed(record, plan=plan_records(prepare(loaded).plan), engines=makers)
    inspected = [inspect(side, image, str(files[side])) for side, image in images.items()]
    gates = check_gates(record.width, record.height, record.scene_hash, inspected)
    gates += tuple(gate_same_exposure(*pair) for pair in pairwise(inspected))
    record = changed(record, gates=gates)
    failed = [gate.message for gate in gates if not gate.passed]
    if failed:
        return SceneRun(ended(record, Status.GATE_FAILED, "\n".join(failed)))
    place = out / name
    place.mkdir(parents=True, exist_ok=True)
    kept = {side: _kept(path, place / f"{side}.exr") for side, path in files.items()}
    sides, differences = write_pictures(images, kept, place, scene.image.exposure_stops)
    folder = references_folder(loaded.path, references)
    truth = read_scene_truth(folder, name, scene)
    try:
        observed = observe(scene, images, PAIRS, truth, max(_gather_radius_m(image) for image in images.values()))
    except NothingToMeasure as nothing:
        return SceneRun(ended(record, Status.SCENE_ERROR, str(nothing)))
    if not any(each.measured or each.unmeasured for each in observed):
        return SceneRun(ended(record, Status.SCENE_ERROR, NOTHING_KNOWN))
    whole = global_metrics(Pair.CANDIDATE_REFERENCE, images, scene.image.exposure_stops)
    record = changed(record, images=sides, differences=differences, global_metrics=whole)
    return SceneRun(record, observed, references=folder)


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
