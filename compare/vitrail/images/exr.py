"""Read and write radiance images: OpenEXR with named layers. The only door to OpenImageIO.

Channels: ``R G B`` radiance; ``half_a.* half_b.*`` two independent halves whose mean it is; ``variance.*`` of the mean,
left out where it is (half_a - half_b)^2 / 4; any other ``name.R name.G name.B`` is the layer of a phenomenon. What is
in the file is returned as it is: sizes, NaN and 8-bit data are for the gates of the judge.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np
import OpenImageIO as oiio

from vitrail.base.fault import Fault

RESERVED = ("half_a", "half_b", "variance")
HALF_MAX = 65504.0

REC_709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
"""x and y of red, green, blue and white."""

INTEGERS = {"uint": "uint32", "int": "int32"}
"""What OpenImageIO calls short and everybody else does not."""

MOST_BYTES = 2**32
"""Size of the largest file that is read."""

MOST_NUMBERS = 2**29
"""Pixels times channels of the largest image: 4096 x 4096 with ten layers."""


class ImageError(Fault):
    """An image cannot be read or written: its file, what is wrong with it, and what to do."""

    def __init__(self, file: str | Path, what: str, remedy: str) -> None:
        super().__init__(what, remedy)
        self.file = str(file)

    def __str__(self) -> str:
        return f"{self.file}: {self.what}; {self.remedy}"


@dataclass(frozen=True)
class ImageLayers:
    """One rendered image, float64 arrays (height, width, 3), row 0 on top, W sr^-1 m^-2.

    ``pixel_type`` is that of the file: ``float``, ``half``, ``uint8`` and so on.
    """

    radiance: np.ndarray
    half_a: np.ndarray | None = None
    half_b: np.ndarray | None = None
    variance: np.ndarray | None = None
    layers: Mapping[str, np.ndarray] = field(default_factory=dict)
    metadata: Mapping[str, str | int | float] = field(default_factory=dict)
    pixel_type: str = "float"

    @property
    def width(self) -> int:
        return int(self.radiance.shape[1])

    @property
    def height(self) -> int:
        return int(self.radiance.shape[0])


def read_image(path: str | Path) -> ImageLayers:
    """Everything in an image file. Raises ImageError for a missing, corrupt, cropped or channel-less file."""
    if not Path(path).is_file():
        raise ImageError(path, "no such image", "render it, or correct the path")
    if Path(path).stat().st_size > MOST_BYTES:
        raise ImageError(path, f"is a file of more than {MOST_BYTES:.3g} bytes", "write a smaller image")
    try:
        return _read(path)
    except UnicodeDecodeError:
        # Names in a damaged header, and the words of OpenImageIO about them, need not be text.
        raise ImageError(path, "is damaged (its header is no text)", "write it again") from None


def _read(path: str | Path) -> ImageLayers:
    source = oiio.ImageInput.open(str(path))
    if source is None:
        raise ImageError(path, f"is not a readable image ({oiio.geterror() or 'unknown format'})", "write it again")
    try:
        spec = source.spec()
        _refuse_cropped(path, spec)
        _refuse_huge(path, spec)
        _refuse_other_primaries(path, spec)
        pixels = source.read_image(0, 0, 0, spec.nchannels, oiio.FLOAT)
        if pixels is None:
            raise ImageError(path, f"is damaged or cut off ({source.geterror()})", "write it again")
    finally:
        source.close()
    with np.errstate(invalid="ignore"):  # a signalling NaN stays one, for the gates
        numbers = np.asarray(pixels, np.float64)
    groups = _groups(path, numbers, list(spec.channelnames))
    half_a, half_b = groups.pop("half_a", None), groups.pop("half_b", None)
    variance = groups.pop("variance", None)
    if variance is None and half_a is not None and half_b is not None:
        variance = (half_a - half_b) ** 2 / 4
    return ImageLayers(
        radiance=groups.pop(""),
        half_a=half_a,
        half_b=half_b,
        variance=variance,
        layers=groups,
        metadata={a.name: a.value for a in spec.extra_attribs if isinstance(a.value, str | int | float)},
        pixel_type=INTEGERS.get(str(spec.format), str(spec.format)),
    )


def write_image(
    path: str | Path,
    radiance: np.ndarray,
    *,
    half_a: np.ndarray | None = None,
    half_b: np.ndarray | None = None,
    variance: np.ndarray | None = None,
    layers: Mapping[str, np.ndarray] | None = None,
    metadata: Mapping[str, str | int | float] | None = None,
    pixel_type: Literal["float", "half"] = "float",
) -> None:
    """Write OpenEXR, one part, losslessly compressed. Raises ImageError when it cannot.

    ``half`` takes half the room and rounds to 11 bits; radiance above 65504 does not fit into it.
    """
    named = {"": radiance, "half_a": half_a, "half_b": half_b, "variance": variance, **(layers or {})}
    present = {name: array for name, array in named.items() if array is not None}
    height, width = radiance.shape[:2]
    for name, array in present.items():
        if array.shape != (height, width, 3):
            what = f"layer {name or 'radiance'} is {array.shape}, not {(height, width, 3)}"
            raise ImageError(path, what, "give every layer one shape")
    if pixel_type == "half" and max(float(np.abs(array).max()) for array in present.values()) > HALF_MAX:
        raise ImageError(path, f"radiance above {HALF_MAX:g} does not fit half floats", "write float")
    spec = oiio.ImageSpec(width, height, 3 * len(present), oiio.HALF if pixel_type == "half" else oiio.FLOAT)
    spec.channelnames = tuple(f"{name}.{c}" if name else c for name in present for c in "RGB")
    spec.attribute("compression", "zip")
    for key, value in (metadata or {}).items():
        spec.attribute(key, value)
    target = oiio.ImageOutput.create(str(path))
    if target is None or not target.open(str(path), spec):
        reason = oiio.geterror() if target is None else target.geterror()
        raise ImageError(path, f"cannot be written ({reason})", "use a writable folder and the extension .exr")
    pixels = np.ascontiguousarray(np.concatenate(list(present.values()), axis=2), dtype=np.float32)
    if not target.write_image(pixels) or not target.close():
        raise ImageError(path, f"writing failed ({target.geterror()})", "is the disk full?")


def write_png(path: str | Path, picture: np.ndarray) -> None:
    """Write display values (height, width, 3) in 0..1 as an 8-bit PNG, for people and never for metrics."""
    height, width = picture.shape[:2]
    spec = oiio.ImageSpec(width, height, 3, oiio.UINT8)
    target = oiio.ImageOutput.create(str(path))
    if target is None or not target.open(str(path), spec):
        raise ImageError(path, "cannot be written", "use a writable folder and the extension .png")
    target.write_image(np.ascontiguousarray(np.clip(picture, 0, 1) * 255 + 0.5).astype(np.uint8))
    target.close()


def _refuse_cropped(path: str | Path, spec: oiio.ImageSpec) -> None:
    """A data window that is not the whole picture would be read as a smaller image in the wrong place."""
    data = (spec.x, spec.y, spec.width, spec.height)
    full = (spec.full_x, spec.full_y, spec.full_width, spec.full_height)
    if data != full:
        raise ImageError(path, f"holds the window {data} of a picture {full}", "write the whole picture")


def _refuse_other_primaries(path: str | Path, spec: oiio.ImageSpec) -> None:
    """Colours of other primaries have other numbers; a header that says nothing means Rec. 709, as OpenEXR does."""
    said = spec.get("chromaticities")
    if said is not None and not np.allclose(np.array(said, float).reshape(-1), REC_709, atol=2e-3):
        what = f"has the primaries {', '.join(f'{each:.4g}' for each in said)} in its header (chromaticities)"
        raise ImageError(path, what, "convert it to linear Rec. 709 with the white point D65")


def _refuse_huge(path: str | Path, spec: oiio.ImageSpec) -> None:
    """A header can announce more than any memory holds, in a file of a few bytes."""
    numbers = spec.width * spec.height * spec.nchannels
    if spec.depth > 1 or numbers > MOST_NUMBERS:
        what = f"announces {spec.width} x {spec.height} pixels of {spec.nchannels} channels"
        raise ImageError(path, what, f"write one flat image of at most {MOST_NUMBERS} numbers")


def _groups(path: str | Path, pixels: np.ndarray, names: list[str]) -> dict[str, np.ndarray]:
    """Layer name to array; the radiance has the empty name."""
    index = {name: i for i, name in enumerate(names)}
    prefixes = list(dict.fromkeys(name.rpartition(".")[0] for name in names if name.rpartition(".")[2] in "RGB"))
    groups = {}
    for prefix in prefixes:
        wanted = [f"{prefix}.{c}" if prefix else c for c in "RGB"]
        if all(name in index for name in wanted):
            groups[prefix] = pixels[..., [index[name] for name in wanted]].copy()
    if "" not in groups:
        raise ImageError(path, f"has no channels R, G, B, only {', '.join(names)}", "rename the radiance to R, G, B")
    if ("half_a" in groups) != ("half_b" in groups):
        raise ImageError(path, "has one of half_a, half_b", "write both halves or none")
    return groups
