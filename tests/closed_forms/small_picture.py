"""A small picture of a scene written as text, rendered by the tracer with everything on."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from vitrail.engines.tracer import Tracer
from vitrail.geometry.world import World
from vitrail.images.exr import read_image
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.analyse import everything
from vitrail.plan.budget import settings_for
from vitrail.scene.load import load_text

Pixels = np.ndarray[Any, np.dtype[np.float64]]


def picture(text: str, *, photons: int = 0) -> Pixels:
    """Radiance, (height, width, 3)."""
    scene = load_text(text).scene
    world = World.of_scene(scene)
    plan = everything(world)
    settings = settings_for(world, plan, "draft", photons=photons)
    with tempfile.TemporaryDirectory(prefix="vitrail-small-") as folder:
        rendering = Tracer().render(lower_tracer(world, plan, settings), Path(folder), threads=1)
        return read_image(rendering.image_path).radiance
