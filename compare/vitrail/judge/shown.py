"""In which picture an observation is measured: the scene's own, or a view of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from vitrail.geometry.camera import View
from vitrail.geometry.patch import corners_around
from vitrail.images.exr import ImageLayers, read_image
from vitrail.images.patch import PatchGrid, PatchSamples, make_grid, sample_patch
from vitrail.judge.comparison import PatchRecord
from vitrail.judge.lost_light import LostLight
from vitrail.judge.view_record import ViewRecord
from vitrail.scene.model import Camera, Image, Patch, Scene


@dataclass(frozen=True)
class Shown:
    """What one camera saw: ``images`` by side, all of one size.

    ``record`` is that of a view, None for the scene's own picture; ``lost`` is what no engine shows there.
    """

    camera: Camera
    image: Image
    images: Mapping[str, ImageLayers]
    record: ViewRecord | None = None
    lost: LostLight = LostLight()

    @classmethod
    def by_scene(cls, scene: Scene, images: Mapping[str, ImageLayers]) -> Shown:
        """The scene's own picture."""
        return cls(scene.camera, scene.image, images)

    @classmethod
    def of_record(cls, view: ViewRecord, root: Path) -> Shown:
        """A view of a finished comparison; its files are below ``root``. Raises ImageError."""
        camera = Camera(
            kind=view.kind,
            position=view.position,
            look_at=view.look_at,
            up=view.up,
            fov_deg=view.fov_deg,
            height=view.height_m,
        )
        images = {each.side: read_image(root / each.exr) for each in view.images}
        return cls(camera, Image(width=view.width, height=view.height), images, view)

    def grid(self, patch: Patch) -> PatchGrid:
        return make_grid(self.camera, self.image, patch)

    def samples(self, side: str, patch: Patch, grid: PatchGrid) -> PatchSamples:
        """One side's light on a patch."""
        found = self.images[side]
        halves = {"half_a": found.half_a, "half_b": found.half_b}
        return sample_patch(found.radiance, self.camera, self.image, patch, **halves, layers=found.layers, grid=grid)


def patch_record(scene: Scene, patch: Patch, grid: PatchGrid) -> PatchRecord:
    """The patch with its outline in the scene's own picture, for the page to draw."""
    return PatchRecord(
        center=patch.center,
        u=patch.u,
        v=patch.v,
        outline_px=outline_px(scene.camera, scene.image, patch),
        coverage=min(float(grid.coverage.mean()), 1.0),
    )


def outline_px(camera: Camera, image: Image, patch: Patch) -> tuple[tuple[float, float], ...]:
    """The corners of a patch in a picture, one after the other around it; none where one is behind the camera."""
    x, y, depth = View.of(camera, image).project(np.array(corners_around(patch)))
    if not (np.all(depth > 0) and np.isfinite(x).all() and np.isfinite(y).all()):
        return ()
    return tuple((round(float(a), 2), round(float(b), 2)) for a, b in zip(x, y, strict=True))
