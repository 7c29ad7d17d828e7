"""An image of the sky: what a file must hold to be one, and what is wrong with those that a scene names."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from vitrail.images.exr import ImageError, read_image
from vitrail.scene.check import CheckResult, check_file
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.load import Loaded

OPENEXR = b"\x76\x2f\x31\x01"
"""How a file of OpenEXR begins, whatever its name ends in."""


def read_sky(path: Path) -> np.ndarray:
    """The radiance of a lat-long image, (height, width, 3), W sr^-1 m^-2, none negative. Raises ImageError."""
    try:
        with path.open("rb") as file:
            begins = file.read(len(OPENEXR))
    except OSError as error:
        raise ImageError(f"{path}: {(error.strerror or 'cannot be read').lower()}; check the path") from None
    if begins != OPENEXR:
        raise ImageError(f"{path}: is not an OpenEXR file; write it again as EXR with R, G and B")
    radiance = read_image(path).radiance
    bad = ~(np.isfinite(radiance) & (radiance >= 0))
    if bad.any():
        row, column, channel = (int(each) for each in np.argwhere(bad)[0])
        value = f"{radiance[row, column, channel]:g} at pixel x={column} y={row} (channel {'RGB'[channel]})"
        raise ImageError(f"{path}: is {value}; make all of it finite and not negative")
    return radiance


def check_file_and_skies(path: str | Path) -> CheckResult:
    """``check_file``, and each image of the sky that the scene names is one; never raises for what a file says."""
    result = check_file(path)
    if result.loaded is None or result.errors:
        return result
    found = [*result.diagnostics, *_faults(result.loaded)]
    return replace(result, diagnostics=tuple(sorted(found, key=lambda each: each.order)))


def _faults(loaded: Loaded) -> Iterator[Diagnostic]:
    """What is wrong with each image, at the place that names it."""
    for index, light in enumerate(loaded.scene.lights):
        if light.environment is None or light.environment.file is None:
            continue
        file = loaded.path.parent / light.environment.file
        try:
            read_sky(file)
        except ImageError as error:
            what, _, remedy = str(error).removeprefix(f"{file}: ").rpartition("; ")
            line, col = loaded.places.of("lights", index, "environment", "file")
            yield Diagnostic(str(loaded.path), line, col, f"the sky `{light.environment.file}` {what}", remedy)
