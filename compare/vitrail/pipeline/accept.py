"""Accept an image as the reference of its scene: a deliberate act with a reason, and with the old beside the new."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from vitrail.base.progress import Progress, silent
from vitrail.engines.base import Engine
from vitrail.images.exr import ImageLayers, read_image
from vitrail.judge.comparison import Pair
from vitrail.judge.gates import check_gates
from vitrail.judge.observe import Observed, observe
from vitrail.judge.reference_files import ReferencesError
from vitrail.judge.references import SceneTruth
from vitrail.judge.stored import Provenance, Stored, read_provenance, read_stored, stored_content, write_stored
from vitrail.pipeline.gated_images import inspect
from vitrail.pipeline.job import prepare
from vitrail.pipeline.run import run
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash


@dataclass(frozen=True)
class Proposal:
    """An image that may become the reference of a scene, and the one it would replace."""

    loaded: Loaded
    folder: Path
    image: ImageLayers
    provenance: Provenance
    older: Stored | None
    older_is_unusable: str = ""

    def changes(self) -> tuple[Observed, ...]:
        """Every number of the new image against the old one; nothing where there is none of the same size."""
        if self.older is None or self.older.image.radiance.shape != self.image.radiance.shape:
            return ()
        images = {"tracer": self.image, "stored": self.older.image}
        return observe(self.loaded.scene, images, (Pair.TRACER_STORED,), SceneTruth(), 0.0)

    @property
    def is_unchanged(self) -> bool:
        """Whether the image, as it would be stored, has the very pixels that were accepted before."""
        try:
            accepted = read_provenance(self.folder, self.loaded.path.stem).content
        except ReferencesError:
            return False
        return stored_content(self.image) == accepted

    def accept(self) -> Path:
        """Put the image in its place; returns its path."""
        return write_stored(self.folder, self.loaded.path.stem, self.image, self.provenance)


def propose_rendering(
    loaded: Loaded,
    folder: Path,
    because: str,
    work: Path,
    *,
    engine: Engine,
    quality: Quality,
    overrides: Mapping[str, object],
    threads: int = 0,
    progress: Progress = silent,
) -> Proposal:
    """Render a scene with the tracer and propose the image. Raises EngineFailure and ReferencesError."""
    job = prepare(loaded, quality, overrides)
    made = run(job, engine, work, threads=threads, progress=progress)
    record = {**made.record, "settings": job.settings.as_record()}
    return _proposal(loaded, folder, because, read_image(made.image_path), record, quality)


def propose_from_run(
    loaded: Loaded,
    folder: Path,
    because: str,
    run: Path,
    scene: Mapping[str, Any],
    content: str | None = None,
    *,
    engine: Engine,
    work: Path,
) -> Proposal:
    """Propose the tracer's image of a finished comparison; ``scene`` is its entry in that run's results.json.

    ``content`` is that of the image which somebody looked at, where somebody did; another one is refused. A picture
    for people, larger or beside views with fewer samples, is no reference: ``engine`` renders the scene at its own size
    into ``work``, with the settings of that run. Raises EngineFailure and ReferencesError.
    """
    if scene["scene_hash"] != scene_hash(loaded.scene):
        raise ReferencesError(
            f"{loaded.path}: has changed since the run in {run}; compare it again before you accept it"
        )
    made = next((image for image in scene["images"] if image["side"] == "tracer"), None)
    made_by = next((each for each in scene["engines"] if each["engine"] == "tracer"), None)
    if made is None or made_by is None:
        raise ReferencesError(f"{run}: has no image of the tracer for {scene['name']}; compare the scene again")
    image = read_image(run / made["exr"])
    if content is not None and stored_content(image) != content:
        raise ReferencesError(
            f"{run / made['exr']}: is not the image that was decided on; open the report and decide again"
        )
    settings, has_views = scene["settings"], any(entry.get("view") for entry in scene["observations"])
    if image.width == loaded.scene.image.width and not has_views:
        record = {**made_by["record"], "settings": settings}
        return _proposal(loaded, folder, because, image, record, settings["quality"])
    quality, overrides = Quality(settings["quality"]), {key: settings[key] for key in settings if key != "quality"}
    return propose_rendering(loaded, folder, because, work, engine=engine, quality=quality, overrides=overrides)


def recipe_of(loaded: Loaded, folder: Path) -> tuple[Quality, dict[str, object], str]:
    """Quality, settings and reason that the scene's reference was made with; its image need not be there.

    Raises ReferencesError when there is no recipe, or one for another scene.
    """
    recipe = read_provenance(folder, loaded.path.stem)
    if recipe.scene_hash != scene_hash(loaded.scene):
        raise ReferencesError(f"{loaded.path}: has changed since its reference was accepted; bless it without --again")
    settings = {key: value for key, value in recipe.settings.items() if key != "quality"}
    return Quality(recipe.quality), settings, recipe.because


def _proposal(
    loaded: Loaded, folder: Path, because: str, image: ImageLayers, record: Mapping[str, Any], quality: str
) -> Proposal:
    """Refuse a reason that says nothing and an image that fails a gate; then look at what would be replaced."""
    if not because.strip():
        raise ReferencesError('a reference needs its reason; say it with --because "..."')
    if record.get("interrupted"):
        raise ReferencesError(f"{loaded.path}: the rendering was interrupted; let it finish")
    scene = loaded.scene
    gates = check_gates(scene.image.width, scene.image.height, scene_hash(scene), [inspect("tracer", image, "image")])
    failed = [gate.message for gate in gates if not gate.passed]
    if failed:
        raise ReferencesError(f"{loaded.path}: " + "; ".join(failed))
    older, trouble = _older(loaded, folder)
    provenance = Provenance(
        scene_hash=scene_hash(scene),
        because=because.strip(),
        engine=str(record["engine"]),
        version=str(record["version"]),
        made=datetime.now(UTC).strftime("%Y-%m-%d"),
        quality=quality,
        content="",
        settings=json.loads(json.dumps(record["settings"])),
    )
    return Proposal(loaded, folder, image, provenance, older, trouble)


def has_usable(loaded: Loaded, folder: Path) -> bool:
    """Whether the scene has a stored image that shows the scene as it is."""
    return _older(loaded, folder)[0] is not None


def _older(loaded: Loaded, folder: Path) -> tuple[Stored | None, str]:
    """The present reference, or why there is none that can be used."""
    try:
        return read_stored(folder, loaded.path.stem, scene_hash(loaded.scene)), ""
    except ReferencesError as error:
        return None, str(error)
