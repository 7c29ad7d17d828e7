"""What a foreign renderer must get right before it is judged: the camera, the units of light, range and colour.

A renderer that puts its picture on the wrong pixels, or its light in the wrong unit, would be called wrong in every
phenomenon. So its images of ``scenes/conformance`` are held against their closed forms first, and where one of them
does not agree no other image of it is judged.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.images.exr import ImageLayers
from vitrail.judge.comparison import Verdict
from vitrail.judge.records import Gate, Results, Status
from vitrail.judge.reference_files import ReferencesError
from vitrail.judge.thresholds import own_references
from vitrail.pipeline.scene_record import ended
from vitrail.pipeline.scene_run import SceneRun
from vitrail.scene.load import Loaded, load
from vitrail.scene.print import scene_hash

SCENES = ("camera", "units", "colour")
OUR_HEADER = "vitrail:engine"
"""Both engines of this project write it; they pass the conformance scenes in our own tests."""


def conformance_scenes() -> tuple[Loaded, ...]:
    """The scenes, in the order in which an adapter is best mended."""
    folder = own_references().parent / "scenes" / "conformance"
    return tuple(load(folder / f"{name}.yaml") for name in SCENES)


def is_conformance_scene(loaded: Loaded) -> bool:
    """Whether a scene is one of those that prove a renderer; they need no proof before them."""
    return scene_hash(loaded.scene) in {scene_hash(each.scene) for each in conformance_scenes()}


def proof_images(folder: Path) -> dict[str, Path]:
    """The image of each conformance scene in a folder. Raises ReferencesError when one is missing."""
    found = {name: folder / f"{name}.exr" for name in SCENES}
    missing = [str(path) for path in found.values() if not path.is_file()]
    if missing:
        raise ReferencesError(
            f"{', '.join(missing)}: missing; render scenes/conformance/*.yaml with the renderer that is to be judged"
        )
    return found


def why_unproven(loaded: Loaded, images: Mapping[str, ImageLayers]) -> str:
    """Why images must not be judged without proof, or nothing: one that no engine of ours has signed is foreign."""
    foreign = [side for side, image in images.items() if OUR_HEADER not in image.metadata]
    if not foreign or is_conformance_scene(loaded):
        return ""
    return f"{' and '.join(foreign)}: made by a renderer that has not shown that it conforms"


def behind_gate(run: SceneRun, failure: str) -> SceneRun:
    """A scene's run with the gate that its renderer conforms; behind a closed gate nothing is judged."""
    gate = Gate(gate="conformance", passed=not failure, message=failure or f"{', '.join(SCENES)} agree")
    record = changed(run.record, gates=(*run.record.gates, gate))
    if not failure:
        return replace(run, record=record)
    message = f"{run.record.message}\n{failure}".strip()
    return SceneRun(ended(changed(record, global_metrics=()), Status.GATE_FAILED, message))


def failure_of(proofs: Results) -> str:
    """What to say of a renderer whose images of the conformance scenes have been judged; nothing if all agree."""
    failed = [scene for scene in proofs.scenes if scene.verdict is not Verdict.AGREES]
    if not failed:
        return ""
    words = ", ".join(f"{scene.name} {scene.verdict.value if scene.verdict else scene.message}" for scene in failed)
    if all(scene.verdict is Verdict.INCONCLUSIVE for scene in failed):
        return f"the renderer's images are too noisy to show that it conforms ({words}); render them with more samples"
    return f"the renderer does not conform ({words}); mend its adapter first"
