"""What a pass is: the lowered scene with a seed and a gather radius of its own, both functions of its number alone.

So passes are independent, any of them can be made at any time, and their mean does not depend on who made them. The
radius shrinks as Knaus and Zwicker (2011) have it, r^2(i + 1) = r^2(i) (i + a) / (i + 1): after N passes the mean
square radius, and with it the blur of the mean image, has fallen as N^(a - 1), and its variance as N^-a.
"""

from __future__ import annotations

import hashlib
import math
from typing import Any

from vitrail.base.changed import changed
from vitrail.base.fault import Fault
from vitrail.plan.settings import Settings
from vitrail.scene.model import Scene

ALPHA = 2 / 3
"""Balances blur against noise: both errors, the square of the blur and the variance, then fall as N^(-2/3)."""

LEAST_SAMPLES = 2
"""One sample looks through the centre of its pixel, in each pass the same way: passes would refine no edge."""


def pass_settings(scene: Scene, settings: Settings, *, samples_given: bool) -> Settings:
    """The settings of one pass; a scene about its samples keeps them. Raises Fault for one sample that was asked
    for."""
    if settings.samples >= LEAST_SAMPLES or scene.image.samples is not None:
        return settings
    if samples_given:
        what = "one sample is the centre of its pixel in every pass, and more passes would refine no edge"
        raise Fault(what, f"ask for {LEAST_SAMPLES} samples or more")
    return changed(settings, samples=LEAST_SAMPLES)


def lowered_pass(lowered: dict[str, Any], number: int) -> dict[str, Any]:
    """The tracer's input for pass ``number``, from 1; the first is the plain rendering."""
    settings = lowered["settings"]
    own = {
        "seed": seed_of_pass(settings["seed"], number),
        "gather_radius_m": gather_radii_m(settings["gather_radius_m"], number)[-1],
    }
    return {**lowered, "settings": {**settings, **own}}


def seed_of_pass(seed: int, number: int) -> int:
    """63 bits; those of another seed or pass have nothing to do with it."""
    if number == 1:
        return seed
    digest = hashlib.sha256(f"vitrail pass {number} of seed {seed}".encode()).digest()
    return int.from_bytes(digest[:8], "little") >> 1


def square_radii(passes: int) -> list[float]:
    """Square gather radius of the passes from the first on, over that of the first."""
    squares = [1.0]
    for i in range(1, passes):
        squares.append(squares[-1] * (i + ALPHA) / (i + 1))
    return squares


def gather_radii_m(first_m: float, passes: int) -> list[float]:
    """Gather radius of the passes from the first on, metres."""
    return [first_m * math.sqrt(square) for square in square_radii(passes)]


def blur_radius_m(first_m: float, passes: int) -> float:
    """Root of the mean square gather radius, metres: the one disc that blurs as the mean of the passes is blurred."""
    return first_m * math.sqrt(math.fsum(square_radii(passes)) / passes)
