"""What must hold before any metric means anything: each gate has one question, one answer and its own message.

FLIP swallows a NaN pixel, SSIM turns wholly NaN, and image tools have passed two pictures of different size; so
nothing is measured until every gate is passed. Gates report all that is wrong, not the first.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from vitrail.judge.records import Gate

COLOUR_CHANNELS = ("R", "G", "B")
HALVES_ROUND = 4e-3
"""What an image may differ from the mean of its halves, as a share: each of three is rounded to 11 bits at most."""

LINEAR_PIXELS = ("float", "half", "double")


@dataclass(frozen=True)
class Inspected:
    """What a gate may know of one image file: its header as written and its radiance (height, width, 3)."""

    side: str
    file: str
    width: int
    height: int
    channels: tuple[str, ...]
    pixel_type: str
    radiance: np.ndarray | None
    halves: tuple[np.ndarray, np.ndarray] | None = None
    metadata: Mapping[str, str] = field(default_factory=dict)


def check_gates(
    width: int, height: int, scene_hash: str, images: Sequence[Inspected], *, may_be_black: bool = False
) -> tuple[Gate, ...]:
    """Pass every image of a scene through every gate.

    A whole picture without light has measured nothing; one of a patch alone ``may_be_black``, deep in a shadow.
    """
    gates = [gate for image in images for gate in _one_image(width, height, scene_hash, image)]
    gates += [] if may_be_black else [gate_light(image) for image in images]
    return (*gates, *(_same_settings(first, second) for first, second in zip(images, images[1:], strict=False)))


def _one_image(width: int, height: int, scene_hash: str, image: Inspected) -> list[Gate]:
    """The gates that need one image and the scene."""
    return [
        gate_size(width, height, image),
        gate_channels(image),
        gate_linear(image),
        gate_finite(image),
        gate_halves(image),
        gate_exposure(image),
        gate_scene(scene_hash, image),
    ]


def gate_size(width: int, height: int, image: Inspected) -> Gate:
    good = (image.width, image.height) == (width, height)
    return _gate("size", image, good, f"is {image.width} x {image.height}, the scene says {width} x {height}")


def gate_channels(image: Inspected) -> Gate:
    missing = [name for name in COLOUR_CHANNELS if name not in image.channels]
    return _gate(
        "channels", image, not missing, f"has no channel {', '.join(missing)}; found {', '.join(image.channels)}"
    )


def gate_linear(image: Inspected) -> Gate:
    """An 8- or 16-bit integer image is display-referred: its radiance is lost."""
    good = image.pixel_type in LINEAR_PIXELS
    return _gate("linear", image, good, f"holds {image.pixel_type} pixels; write linear float or half (EXR)")


def gate_finite(image: Inspected) -> Gate:
    """Name the first pixel that is not a number, because that is where the search starts."""
    bad = np.empty((0, 3), dtype=int) if image.radiance is None else np.argwhere(~np.isfinite(image.radiance))
    where = ""
    if len(bad):
        row, column, channel = (int(index) for index in bad[0])
        value = image.radiance[row, column, channel] if image.radiance is not None else 0.0
        pixels = len({(int(r), int(c)) for r, c, _ in bad})
        where = f"has {value} at pixel x={column} y={row} (channel {COLOUR_CHANNELS[channel]}), {pixels} bad in all"
    return _gate("finite", image, not len(bad), where)


def gate_halves(image: Inspected) -> Gate:
    """The image is the mean of its halves; where they are of another picture, their noise says nothing of this one."""
    if image.halves is None or image.radiance is None:
        return _gate("halves", image, True, "")
    first, second = image.halves
    with np.errstate(invalid="ignore"):
        off = np.abs((first + second) / 2 - image.radiance)
        size = np.maximum(np.abs(first) + np.abs(second), np.abs(image.radiance))
    brightest = float(np.max(size, initial=0.0, where=np.isfinite(size)))
    wrong = np.argwhere(off > HALVES_ROUND * size + HALVES_ROUND**2 * brightest)
    where = ""
    if len(wrong):
        row, column, channel = (int(index) for index in wrong[0])
        mean = (first[row, column, channel] + second[row, column, channel]) / 2
        where = (
            f"is {image.radiance[row, column, channel]:.4g} at pixel x={column} y={row} (channel "
            f"{COLOUR_CHANNELS[channel]}) and the mean of its halves {mean:.4g}; write their mean, or leave them out"
        )
    return _gate("halves", image, not len(wrong), where)


def gate_light(image: Inspected) -> Gate:
    """A wholly black image equals any other black image; it has measured nothing."""
    # What an integer file holds has no scale, and another gate says so.
    radiance = image.radiance if image.pixel_type in LINEAR_PIXELS else None
    lit = radiance is None or not np.isfinite(radiance).all() or bool(np.any(radiance != 0))
    return _gate("light", image, lit, "is black everywhere")


def gate_exposure(image: Inspected) -> Gate:
    """Radiance is compared, so the pixels must not have been exposed."""
    stops = image.metadata.get("vitrail:exposure_stops", "0")
    try:
        good = float(stops) == 0
    except ValueError:
        good = False
    return _gate("exposure", image, good, f"was exposed by {stops} stops; radiance without exposure is needed")


def gate_scene(scene_hash: str, image: Inspected) -> Gate:
    """An image that says which scene it shows must show this one; a foreign image need not say."""
    said = image.metadata.get("vitrail:scene_hash")
    good = said is None or said == scene_hash
    return _gate("scene", image, good, f"shows scene {str(said)[:12]}, this scene is {scene_hash[:12]}; render again")


def _same_settings(first: Inspected, second: Inspected) -> Gate:
    """Two kernels of different width make two different pictures of one caustic."""
    ours, theirs = _settings(first), _settings(second)
    unlike = [
        f"{key} {ours[key]} against {theirs[key]}"
        for key in ("gather_radius_m",)
        if key in ours and key in theirs and ours[key] != theirs[key]
    ]
    message = f"{first.side} and {second.side}: " + ("; ".join(unlike) if unlike else "same settings")
    return Gate(gate="settings", passed=not unlike, message=message)


def gate_same_exposure(first: Inspected, second: Inspected) -> Gate:
    """One picture that is a multiple of another at every pixel is exposed, or in another unit: no phenomenon does that.

    For images whose makers say nothing of exposure. A factor within 10 % of 1 may be a finding, so it is measured.
    """
    factor = _uniform_factor(first, second)
    good = factor is None or abs(factor - 1) < 0.1
    text = f"is {factor or 1:.4g} times {second.file} at every pixel ({math.log2(factor or 1):+.2f} stops)"
    return _gate("exposure", first, good, f"{text}; write both as radiance, without exposure, in one unit")


def _uniform_factor(first: Inspected, second: Inspected) -> float | None:
    """The factor between two pictures where it is the same to 0.1 % wherever there is light; else None."""
    if first.radiance is None or second.radiance is None or first.radiance.shape != second.radiance.shape:
        return None
    lit = (second.radiance > 1e-3 * np.max(second.radiance, initial=0.0)) & (first.radiance > 0)
    if not lit.any() or not (np.isfinite(first.radiance).all() and np.isfinite(second.radiance).all()):
        return None
    ratios = first.radiance[lit] / second.radiance[lit]
    middle = float(np.median(ratios))
    return middle if np.all(np.abs(ratios - middle) <= 1e-3 * middle) else None


def _settings(image: Inspected) -> dict[str, object]:
    try:
        found = json.loads(image.metadata.get("vitrail:settings", "{}"))
    except json.JSONDecodeError:
        return {}
    return found if isinstance(found, dict) else {}


def _gate(name: str, image: Inspected, passed: bool, failure: str) -> Gate:
    return Gate(
        gate=name, passed=passed, message=f"{image.side}: " + ("passed" if passed else f"{image.file} {failure}")
    )
