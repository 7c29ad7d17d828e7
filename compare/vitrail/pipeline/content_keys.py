"""The content that decides an image, as a key: the same key means the same image, which is then rendered once."""

from __future__ import annotations

from typing import Any

from vitrail.base.canonical_json import canonical_json
from vitrail.engines.cache import content_key
from vitrail.lower.povray import PovrayScene


def tracer_key(build: str, lowered: dict[str, Any]) -> str:
    """Of the tracer's image: its input, which holds the meshes and skies of the scene."""
    return content_key("tracer", build, [canonical_json(lowered)])


def povray_key(build: str, lowered: PovrayScene | None) -> str:
    """Of POV-Ray's images: the texts of its runs, and how their pictures are added up; empty where there is none.

    The scene's hash is in it too, because the image carries it: two scenes may have one text.
    """
    if lowered is None:
        return ""
    sums = [f"{run.name} {run.half} {run.gain}" for run in lowered.runs]
    sizes = [
        f"{each.view} {each.width} {each.height} {each.samples_across} {each.samples_down}"
        for run in lowered.runs
        for each in run.pictures
    ]
    texts = [text for run in lowered.runs for text in run.texts.values()]
    return content_key("povray", build, [lowered.scene_hash, *sums, *sizes, *texts, str(lowered.settings)])
