"""Numbers that are legal one by one and absurd together."""

from __future__ import annotations

from collections.abc import Iterator

from vitrail.check.findings import Findings
from vitrail.scene.model import Part

LARGEST_M = 1e9
"""Beyond a million kilometres a position in double precision is coarser than light's wavelength."""

WIDEST_RATIO = 1e9
"""Largest over smallest length of a scene; beyond it the small end drowns in the rounding of the large one."""

BRIGHTEST = 1e30
"""Squares of radiances beyond this overflow the single-precision images [O part 2, 35]."""

_DIRECTIONS = {"normal", "direction", "up"}
_LENGTHS = {"radius", "radius_from", "radius_to", "size", "thickness", "diameter", "side", "distance", "height"}
_POSITIONS = {"center", "point", "min", "max", "from", "to", "position", "look_at", "u", "v", "translate", "profile"}
_LIGHT = {"irradiance", "intensity", "radiance", "emission"}


def check_sizes(findings: Findings) -> None:
    """Refuse lengths above LARGEST_M and light above BRIGHTEST; warn of extreme ratios of sizes."""
    sizes: list[tuple[float, tuple[str | int, ...]]] = []
    for path, number in _numbers(findings.scene, ()):
        key = next((str(step) for step in reversed(path) if isinstance(step, str)), "")
        if key in _LIGHT and number > BRIGHTEST:
            remedy = f"keep light below {BRIGHTEST:g}; images are single precision"
            findings.error(f"`{key}` is {number:g}, too bright for an image", remedy, *path)
        if key in (_LENGTHS | _POSITIONS) - _DIRECTIONS:
            if abs(number) > LARGEST_M:
                remedy = f"keep every length and position below {LARGEST_M:g} m; choose the sun as `directional` light"
                findings.error(f"`{key}` is {number:g} m, absurdly large", remedy, *path)
            elif key in _LENGTHS and number > 0 and path[0] == "objects":
                sizes.append((number, path))
    if not sizes:
        return
    smallest, largest = min(sizes), max(sizes)
    if largest[0] > WIDEST_RATIO * smallest[0]:
        what = f"the scene spans sizes from {smallest[0]:g} m to {largest[0]:g} m"
        findings.warning(what, "bring the sizes closer together, or expect rounding to show", *smallest[1])


def _numbers(value: object, path: tuple[str | int, ...]) -> Iterator[tuple[tuple[str | int, ...], float]]:
    """Every number of a scene with its path."""
    if isinstance(value, Part):
        for key, inner in value.entries():
            yield from _numbers(inner, (*path, key))
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield from _numbers(inner, (*path, key))
    elif isinstance(value, tuple):
        for index, inner in enumerate(value):
            yield from _numbers(inner, (*path, index))
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path, float(value)
