"""Pictures for people beside the radiance: display PNGs, the FLIP map, the signed difference."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from vitrail.images.coarser import averaged
from vitrail.images.display import Display
from vitrail.images.exr import ImageLayers, write_image, write_png
from vitrail.images.false_colour import heat, signed_difference
from vitrail.judge.records import ImageFiles
from vitrail.judge.stored import stored_content
from vitrail.judge.view_record import ViewImage
from vitrail.metrics.flip import FlipSettings, flip_map


def write_pictures(
    images: Mapping[str, ImageLayers], files: Mapping[str, Path], place: Path, exposure_stops: float, times: int = 1
) -> tuple[tuple[ImageFiles, ...], dict[str, str]]:
    """Write the pictures of one scene into ``place``; returns the files of each side and those of the differences.

    Differences are those of the first two sides; the visible error is that of ``times`` x ``times`` pixels together.
    Paths are relative to the folder above ``place``, where ``results.json`` is.
    """
    display = Display(exposure_stops)
    root = place.parent
    sides = []
    for side, image in images.items():
        png = place / f"{side}.png"
        write_png(png, display.apply(image.radiance))
        content = stored_content(image)
        sides.append(ImageFiles(side=side, exr=_relative(files[side], root), png=_relative(png, root), content=content))
    if len(images) < 2:
        return tuple(sides), {}
    candidate, reference = [averaged(image.radiance, times) for image in images.values()][:2]
    error = flip_map(candidate / display.white, reference / display.white, FlipSettings.around(display))
    error = np.kron(error, np.ones((times, times), error.dtype))
    write_image(place / "error.exr", np.repeat(error[..., None], 3, axis=-1))
    write_png(place / "error.png", heat(error, low=0.0, high=1.0))
    _write_difference(place / "difference.png", images, display)
    named = {"error": "error.exr", "error_picture": "error.png", "difference_picture": "difference.png"}
    return tuple(sides), {key: _relative(place / name, root) for key, name in named.items()}


def write_view_pictures(
    images: Mapping[str, ImageLayers],
    files: Mapping[str, Path],
    place: Path,
    root: Path,
    view: str,
    exposure_stops: float,
) -> tuple[tuple[ViewImage, ...], str]:
    """Write the pictures of one view; returns the files of each side and the difference of the first two sides.

    Paths are relative to ``root``, where ``results.json`` is.
    """
    display, sides = Display(exposure_stops), []
    for side, image in images.items():
        png = place / f"{side}.{view}.png"
        write_png(png, display.apply(image.radiance))
        sides.append(ViewImage(side=side, exr=_relative(files[side], root), png=_relative(png, root)))
    if len(images) < 2:
        return tuple(sides), ""
    difference = place / f"difference.{view}.png"
    _write_difference(difference, images, display)
    return tuple(sides), _relative(difference, root)


def _write_difference(path: Path, images: Mapping[str, ImageLayers], display: Display) -> None:
    """The signed difference of the first two sides, in full colour at a tenth of what is shown as white."""
    candidate, reference = [image.radiance for image in images.values()][:2]
    scale = 0.1 * display.white / 2.0**display.exposure_stops
    write_png(path, signed_difference(candidate, reference, scale=scale))


def _relative(path: Path, root: Path) -> str:
    return Path(os.path.relpath(path, root)).as_posix()
