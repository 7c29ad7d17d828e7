"""An image of the sky is read before a scene counts as good; what is wrong is said at the line that names it."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
import pytest

from vitrail.check.check import check_file
from vitrail.images.exr import write_image, write_png
from vitrail.images.sky import read_sky

SCENE = """
vitrail: 1
camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov_deg: 35}
image: {width: 4, height: 4}
materials: {card: {diffuse: 0.5}}
objects: [{name: card, sphere: {center: [0, 0, 0], radius: 1}, material: card}]
lights:
  - {name: sky, environment: {file: sky.exr}}
"""


def spoilt(path: Path, pixel: float) -> None:
    pixels = np.ones((4, 8, 3))
    pixels[2, 3, 1] = pixel
    write_image(path, pixels)


def truncated(path: Path) -> None:
    write_image(path, np.random.default_rng(1).random((64, 128, 3)))
    path.write_bytes(path.read_bytes()[:20000])


def of_luminance(path: Path) -> None:
    spec = oiio.ImageSpec(8, 4, 1, oiio.FLOAT)
    spec.channelnames = ("Y",)
    file = oiio.ImageOutput.create(str(path))
    assert file is not None and file.open(str(path), spec)
    file.write_image(np.ones((4, 8, 1), np.float32))
    file.close()


def picture(path: Path) -> None:
    write_png(path.with_suffix(".png"), np.ones((4, 8, 3)))
    path.with_suffix(".png").rename(path)


@pytest.mark.parametrize(
    ("write", "words"),
    [
        (lambda path: path.write_text("a sky\n"), "is not an OpenEXR file; write it again as EXR with R, G and B"),
        (lambda path: path.write_bytes(b""), "the file `sky.exr` is empty; paths are relative to the scene file"),
        (picture, "is not an OpenEXR file; write it again as EXR with R, G and B"),
        (lambda path: path.mkdir(), "`sky.exr` is a folder; paths are relative to the scene file"),
        (truncated, "is damaged or cut off"),
        (of_luminance, "has no channels R, G, B, only Y; rename the radiance to R, G, B"),
        (lambda path: spoilt(path, math.nan), "is nan at pixel x=3 y=2 (channel G); make all of it finite"),
        (lambda path: spoilt(path, math.inf), "is inf at pixel x=3 y=2 (channel G); make all of it finite"),
        (lambda path: spoilt(path, -0.5), "is -0.5 at pixel x=3 y=2 (channel G); make all of it finite"),
    ],
    ids=["text", "empty", "png", "folder", "truncated", "luminance", "nan", "infinite", "negative"],
)
def test_what_is_no_sky_is_refused_at_its_line(tmp_path: Path, write, words: str) -> None:
    write(tmp_path / "sky.exr")
    (tmp_path / "scene.yaml").write_text(SCENE)
    result = check_file(tmp_path / "scene.yaml")
    assert not result.is_valid
    (error,) = result.errors
    assert str(error).startswith(f"{tmp_path}/scene.yaml:8:") and words in str(error)


def test_a_sky_is_read_as_it_is(tmp_path: Path) -> None:
    pixels = np.random.default_rng(1).random((4, 8, 3)).astype(np.float32)
    write_image(tmp_path / "sky.exr", pixels)
    (tmp_path / "scene.yaml").write_text(SCENE)
    assert check_file(tmp_path / "scene.yaml").is_valid
    assert np.array_equal(read_sky(tmp_path / "sky.exr"), pixels)
