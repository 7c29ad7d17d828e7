"""An image of the sky: what a file must hold to be one."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from vitrail.base.input_file import InputFileError, look_at
from vitrail.images.exr import ImageError, read_image

MOST_PIXELS = 2**25
"""Pixels of the largest sky, as in the tracer."""

OPENEXR = b"\x76\x2f\x31\x01"
"""How a file of OpenEXR begins, whatever its name ends in."""


def read_sky(path: Path) -> np.ndarray:
    """The radiance of a lat-long image, (height, width, 3), W sr^-1 m^-2, none negative. Raises ImageError."""
    try:
        look_at(path)
        with path.open("rb") as file:
            begins = file.read(len(OPENEXR))
    except InputFileError as error:
        raise ImageError(path, str(error), "check the path") from None
    except OSError as error:
        raise ImageError(path, (error.strerror or "cannot be read").lower(), "check the path") from None
    if begins != OPENEXR:
        raise ImageError(path, "is not an OpenEXR file", "write it again as EXR with R, G and B")
    image = read_image(path)
    radiance = image.radiance
    if image.pixel_type not in ("half", "float"):
        raise ImageError(path, f"holds {image.pixel_type} pixels", "write radiance as float or half")
    if image.width * image.height > MOST_PIXELS:
        what = f"has {image.width} x {image.height} pixels"
        raise ImageError(path, what, f"make it smaller, at most {MOST_PIXELS} pixels such as 8192 x 4096")
    bad = ~(np.isfinite(radiance) & (radiance >= 0))
    if bad.any():
        row, column, channel = (int(each) for each in np.argwhere(bad)[0])
        value = f"{radiance[row, column, channel]:g} at pixel x={column} y={row} (channel {'RGB'[channel]})"
        raise ImageError(path, f"is {value}", "make all of it finite and not negative")
    return radiance
