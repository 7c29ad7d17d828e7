"""One place of a scan in a sentence: where it is, on what, by how much, and in which light."""

from __future__ import annotations

from collections.abc import Sequence

from vitrail.metrics.scan import DifferentRegion

TIMES = 1.5
"""A ratio from here on is told as *times brighter*, a smaller one in percent."""


def place_words(region: DifferentRegion, x: int, y: int, seen: str, layer: str, inside: Sequence[str]) -> str:
    """*outside the patches: 300 pixels at the lower right, on `floor`, are 1.7 times brighter in the tracer (layer
    caustic)*."""
    height, width = region.mask.shape
    where = f"inside {', '.join(f'`{name}`' for name in inside)}" if inside else "outside the patches"
    on = f", on `{seen}`," if seen else ""
    light = f" (layer {layer})" if layer else ""
    return f"{where}: {region.pixels} pixels {corner(x, y, width, height)}{on} are {brighter(region)}{light}"


def corner(x: int, y: int, width: int, height: int) -> str:
    """Where a pixel lies in a picture, by thirds."""
    across = ("left", "", "right")[min(2, 3 * x // width)]
    down = ("upper", "", "lower")[min(2, 3 * y // height)]
    if down and across:
        return f"at the {down} {across}"
    if down:
        return "at the top" if down == "upper" else "at the bottom"
    return f"at the {across}" if across else "in the middle"


def brighter(region: DifferentRegion) -> str:
    """How much brighter a region is, and in which engine."""
    ours, theirs = max(region.candidate, 0.0), max(region.reference, 0.0)
    engine = "the tracer" if region.difference > 0 else "POV-Ray"
    more, less = max(ours, theirs), min(ours, theirs)
    if less <= 0:
        return f"lit in {engine} alone"
    if more / less >= TIMES:
        return f"{more / less:.1f} times brighter in {engine}"
    return f"{100 * (more / less - 1):.2g} % brighter in {engine}"
