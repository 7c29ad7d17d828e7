"""Render small scenes in the real POV-Ray. Without one every test that uses this fails, as it should."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from vitrail.engines.povray import Povray
from vitrail.geometry.world import World
from vitrail.images.exr import ImageLayers, read_image
from vitrail.lower.povray import PovrayScene, lower_povray
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.load import Loaded, load, load_text

HALF_FLOAT = 6e-4
"""POV-Ray's image has 11 bits a channel: 4.9e-4 of rounding, and single-precision colours on the way."""

LOOKING_DOWN = "camera: {kind: orthographic, position: [0, 1, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}"
SMALL = "image: {width: 32, height: 32}"
SUN = "- {name: sun, directional: {direction: [0, -1, 0], irradiance: 3.141592653589793}}"
"""Gives a facing surface of albedo d the radiance d."""


@dataclass(frozen=True)
class Rendered:
    """An image, the run record and the lowered scene behind them."""

    image: ImageLayers
    record: dict[str, Any]
    lowered: PovrayScene

    @property
    def mean(self) -> np.ndarray:
        """Mean radiance per channel."""
        return self.image.radiance.mean(axis=(0, 1))


def scene(
    materials: str, objects: str, lights: str = SUN, camera: str = LOOKING_DOWN, image: str = SMALL, more: str = ""
) -> Loaded:
    """A scene from the bodies of its sections, each line of a list one entry."""
    return load_text(
        "\n".join(
            [
                "vitrail: 1",
                camera,
                image,
                "materials:",
                *("  " + line.strip() for line in materials.strip().splitlines()),
                "objects:",
                *("  " + line.strip() for line in objects.strip().splitlines()),
                "lights:" if lights else "lights: []",
                *("  " + line.strip() for line in lights.strip().splitlines()),
                more,
            ]
        )
    )


def lowered(loaded: Loaded, **settings: object) -> PovrayScene:
    world = World.of(loaded)
    plan = analyse(world)
    return lower_povray(world, plan, settings_for(world, plan, **{"samples": 1, **settings}))


def rendered(loaded: Loaded, **settings: object) -> Rendered:
    """The scene through the whole back end; settings default to one sample a pixel."""
    translated = lowered(loaded, **settings)
    with TemporaryDirectory() as folder:
        made = Povray().render(translated, Path(folder))
        return Rendered(read_image(made.image_path), made.record, translated)


def rendered_file(path: str, **settings: object) -> Rendered:
    return rendered(load(Path(__file__).parents[3] / path), **settings)


def plain_povray(sdl: str, width: int = 32, height: int = 32) -> np.ndarray:
    """An image of hand-written scene text: how POV-Ray behaves without our care."""
    with TemporaryDirectory() as folder:
        (Path(folder) / "scene.pov").write_text(sdl)
        command = ["povray", "+Iscene.pov", "+Oimage.exr", f"+W{width}", f"+H{height}", "+FE", "-D", "-A", "+WT1"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr[-2000:]
        return read_image(Path(folder) / "image.exr").radiance
