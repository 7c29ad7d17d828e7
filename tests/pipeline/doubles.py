"""Engines made of formulas: they answer what they are told, so that the way from scene to verdict is tested alone."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from vitrail.base.progress import Progress, silent
from vitrail.engines.base import EngineFailure, Rendering
from vitrail.images.exr import write_image

CARD = """
vitrail: 1
title: Grey card
camera: {kind: orthographic, position: [0, 1, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}
image: {width: 32, height: 32}
materials: {card: {diffuse: 0.5}}
objects: [{name: card, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}]
lights: [{name: sun, directional: {direction: [0, -1, 0], irradiance: 3.141592653589793}}]
observe: [{name: card, phenomenon: diffusion, patch: {center: [0, 0, 0], u: [0.2, 0, 0], v: [0, 0, -0.2]}}]
"""
"""Radiance 0.5 everywhere."""


@dataclass
class FormulaEngine:
    """Renders ``radiance`` everywhere, with noise of relative size ``noise`` a sample in each half.

    ``noisy`` limits the noise to the scene of that title; ``stays_noisy`` gives samples no effect.
    ``script`` has a word for each render to come: empty to succeed, ``interrupt`` for Ctrl-C, else words to fail with.
    """

    name: str
    radiance: float = 0.5
    noise: float = 0.0
    noisy: str = ""
    stays_noisy: bool = False
    warnings: tuple[str, ...] = ()
    script: list[str] = field(default_factory=list)
    spoil: Callable[[np.ndarray], np.ndarray] = field(default=lambda image: image)
    renders: int = 0

    def version(self) -> str:
        return "1"

    def render(self, lowered: Any, out_dir: Path, *, threads: int = 0, progress: Progress = silent) -> Rendering:
        self.renders += 1
        word = self.script.pop(0) if self.script else ""
        if word == "interrupt":
            raise KeyboardInterrupt
        if word:
            raise EngineFailure(self.name, "it stopped", "mend it", word)
        scene_hash = lowered["scene_hash"] if isinstance(lowered, dict) else lowered.scene_hash
        is_quiet = bool(self.noisy) and (not isinstance(lowered, dict) or lowered["title"] != self.noisy)
        samples = _samples(lowered) if isinstance(lowered, dict) else 1
        noise = 0.0 if is_quiet else self.noise / math.sqrt(1 if self.stays_noisy else samples)
        rng = np.random.default_rng(sum(map(ord, self.name)))
        out_dir.mkdir(parents=True, exist_ok=True)
        metadata = {"vitrail:scene_hash": scene_hash, "vitrail:settings": json.dumps({"seed": 1})}

        def picture(name: str, size: tuple[int, int]) -> Path:
            drawn = [self.radiance * (1 + noise * rng.standard_normal((*size, 3))) for _ in "ab"]
            a, b = (self.spoil(half) for half in drawn)
            write_image(out_dir / name, (a + b) / 2, half_a=a, half_b=b, metadata=metadata)
            return out_dir / name

        path = picture(f"{self.name}.exr", _size(lowered))
        views = {name: picture(f"{self.name}.{name}.exr", size) for name, size in _views(lowered).items()}
        progress("camera", 1, 1)
        record = {
            "engine": self.name,
            "version": "1",
            "cpu_s": {"total": 2.0, "photon_pass": 0.5, "photon_sort": 0.5, "camera": 1.0, "gather": 1.0},
            "counters": {
                "photons_emitted": 9000,
                "photons_stored": 1000 if self.name == "povray" else 5000,
                "gather_queries": 100,
            },
            "settings": {"seed": 1},
            "warnings": list(self.warnings),
        }
        return Rendering(path, record, views)


def _size(lowered: Any) -> tuple[int, int]:
    """Rows and columns of the scene's picture."""
    if isinstance(lowered, dict):
        return lowered["image"]["height"], lowered["image"]["width"]
    return lowered.height, lowered.width


def _samples(lowered: dict[str, Any]) -> int:
    """Samples of a pixel, of a view where there are some."""
    return max((view["samples"] for view in lowered.get("views", ())), default=lowered["settings"]["samples"])


def _views(lowered: Any) -> dict[str, tuple[int, int]]:
    """Rows and columns of each view."""
    if isinstance(lowered, dict):
        return {view["name"]: (view["image"]["height"], view["image"]["width"]) for view in lowered.get("views", ())}
    return {view.name: (view.image.height, view.image.width) for view in lowered.views}
