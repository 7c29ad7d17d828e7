"""An image of the sky: the small lights that stand for it, and the picture that rays see which meet nothing.

The image has the axes of OpenEXR's environment maps: row 0 is up (+y), the middle is +z, a quarter to the left of it
+x. POV-Ray's spherical map begins at +x and turns the same way, so it is the same image a quarter turn on, and without
``interpolate`` it takes the nearest pixel, as the tracer does. POV-Ray reads pixels as half floats.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from pathlib import Path

import numpy as np

from vitrail.base.colour import Triplet
from vitrail.base.vector import Vec
from vitrail.images.exr import ImageError
from vitrail.images.sky import read_sky
from vitrail.lower.povray.refusals.refusal import NotTranslatable, Refusals
from vitrail.lower.povray.text.emitters import Grid, sphere_places
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.sdl import Block, Product, Quoted, block, statement
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Environment, Scene

MOST_PIXELS = 1 << 25
"""8192 x 4096; every process of POV-Ray holds its own copy, in 30 bytes a pixel: 1 GB."""
BRIGHTEST = 32768.0
"""Brightest pixel of a picture for POV-Ray, half of what half floats hold."""


@dataclass(frozen=True, eq=False)
class SkyPicture:
    """A file for POV-Ray, named by its content: what one run sees, ``pixels`` (height, width, 3) of half floats."""

    name: str
    pixels: np.ndarray

    @property
    def sdl(self) -> Block:
        """The sky all around: the image turned so that its middle is +z."""
        image = block("image_map", statement("exr", Quoted(self.name)), statement("map_type", 1))
        return block("sky_sphere", block("pigment", image, statement("rotate", Product(90, "y"))))


@dataclass(frozen=True, eq=False)
class Sky:
    """A lat-long image, ``radiance`` (height, width, 3), W sr^-1 m^-2, none negative."""

    radiance: np.ndarray

    @property
    def peak(self) -> Triplet:
        """The largest radiance of each channel."""
        red, green, blue = self.radiance.max(axis=(0, 1)).tolist()
        return (red, green, blue)

    @cached_property
    def colours(self) -> tuple[Triplet, ...]:
        """For each two channels the pixel in which they differ most, relative to its brightest one."""
        pixels = self.radiance.reshape(-1, 3)
        scale = np.maximum(pixels.max(axis=1), np.finfo(float).tiny)
        found = []
        for one, other in combinations(range(3), 2):
            red, green, blue = pixels[np.argmax(abs(pixels[:, one] - pixels[:, other]) / scale)].tolist()
            found.append((red, green, blue))
        return tuple(found)

    @cached_property
    def _weight(self) -> np.ndarray:
        """How often each pixel is drawn, for its solid angle: by what it sends, evenly in a black sky."""
        sent = self.radiance.sum(axis=2)
        return sent if sent.any() else np.ones_like(sent)

    def directions(self, grid: Grid) -> list[tuple[Vec, Triplet]]:
        """The way each small light shines, and its irradiance on a facing surface.

        They send equal power, summed over the channels. For an image of one radiance these are the lights of
        ``sphere_directions``.
        """
        height, width, _ = self.radiance.shape
        bounds = np.cos(np.pi * np.arange(height + 1) / height)
        weight, solid_angle = self._weight, 2 * np.pi / width * (bounds[:-1] - bounds[1:])
        rows = _cumulative(weight.sum(axis=1) * solid_angle)
        places = list(sphere_places(grid))
        found = []
        for a, b in places:
            row, down = _place(rows, 1 - b)
            column, along = _place(_cumulative(weight[row]), (a - 0.25) % 1)
            # Spread evenly over the solid angle of the pixel.
            up = bounds[row] + (bounds[row + 1] - bounds[row]) * down
            ring, longitude = math.sqrt(max(0.0, 1 - up * up)), math.pi - 2 * math.pi * (column + along) / width
            way = (-ring * math.sin(longitude), -float(up), -ring * math.cos(longitude))
            share = rows[-1] / (weight[row, column] * len(places))
            red, green, blue = (self.radiance[row, column] * share).tolist()
            found.append((way, (red, green, blue)))
        return found

    def picture(self, exposure: Exposure, beside: Triplet) -> SkyPicture:
        """What a run sees of the image; ``beside`` is the radiance of the constant environments."""
        shown = self.radiance + np.array(beside)
        channels = [0, 1, 2] if exposure.channel is None else [exposure.channel] * 3
        pixels = (shown[..., channels] * exposure.light_factor).astype(np.float16)
        digest = hashlib.sha256(repr(pixels.shape).encode() + pixels.tobytes()).hexdigest()
        return SkyPicture(f"sky_{digest[:16]}.exr", pixels.astype(np.float64))


Skies = Mapping[int, Sky]
"""Index of a light to its image, for the environment that is one."""


def skies_of(scene: Scene, folder: Path, refusals: Refusals) -> Skies:
    """The image of the sky, read once; its path is relative to ``folder``. Raises NotTranslatable."""
    found: dict[int, Sky] = {}
    refused: list[Diagnostic] = []
    for index, light in enumerate(scene.lights):
        if not isinstance(light.emitter, Environment) or light.emitter.file is None:
            continue
        path = ("lights", index, "environment", "file")
        try:
            radiance = read_sky(folder / light.emitter.file)
        except ImageError as error:
            what = f"the image of the sky is of no use: {error.file}: {error.what}"
            refused.append(refusals.at(what, error.remedy, *path))
            continue
        if found:
            what, remedy = "POV-Ray shows one image of the sky", "add the images up into one"
            refused.append(refusals.at(what, remedy, *path))
        elif radiance.shape[0] * radiance.shape[1] > MOST_PIXELS:
            what = f"the image of the sky has more than {MOST_PIXELS} pixels, and POV-Ray holds it once a run"
            refused.append(refusals.at(what, "make it smaller, 8192 x 4096 at most", *path))
        else:
            found[index] = Sky(radiance)
    if refused:
        raise NotTranslatable(refused)
    return found


def _cumulative(values: np.ndarray) -> np.ndarray:
    return np.concatenate([[0.0], np.cumsum(values)])


def _place(cumulative: np.ndarray, share: float) -> tuple[int, float]:
    """The interval that holds a share of the whole, never an empty one, and where in it."""
    total = cumulative[-1]
    value = min(share * total, np.nextafter(total, 0))
    index = int(np.searchsorted(cumulative[1:-1], value, side="right"))
    return index, float((value - cumulative[index]) / (cumulative[index + 1] - cumulative[index]))
