"""Shapes that cannot exist, patterns that have nowhere to lie, and files that are not there."""

from __future__ import annotations

import math
from pathlib import Path
from typing import assert_never

from vitrail.check.findings import Findings
from vitrail.scene.model import (
    Box,
    Checker,
    Cone,
    Cylinder,
    Disc,
    Lens,
    Mesh,
    Object,
    Plane,
    Prism,
    Rectangle,
    Sphere,
)

MESH_ENDINGS = (".ply", ".obj")


def check_shapes(findings: Findings) -> None:
    """Check each object by itself: its geometry, its pattern, its file."""
    for index, item in enumerate(findings.scene.objects):
        shape = item.shape
        match shape:
            case Lens():
                _check_lens(findings, index, shape)
            case Prism():
                _check_profile(findings, index, shape)
            case Mesh():
                _check_mesh(findings, index, shape)
            case Sphere() | Plane() | Rectangle() | Disc() | Box() | Cylinder() | Cone():
                pass
            case _:
                assert_never(shape)
        _check_pattern(findings, index, item)


def _check_pattern(findings: Findings, index: int, item: Object) -> None:
    """A checker needs the surface coordinates of a flat shape."""
    material = findings.scene.material_of(item)
    patterned = isinstance(material.diffuse, Checker) or isinstance(material.emission, Checker)
    if patterned and not isinstance(item.shape, Plane | Rectangle | Disc):
        what = f"`{item.name}` is a {item.shape.key}, and a checker lies on flat shapes only"
        remedy = "use plane, rectangle or disc, or give the material one colour"
        findings.error(what, remedy, "objects", index, "material")


# --- lens -----------------------------------------------------------------------------------------------------------


def _check_lens(findings: Findings, index: int, lens: Lens) -> None:
    """A lens's rim must fit on both spheres, and its faces may not cross inside the rim."""
    half = lens.diameter / 2
    for key in ("radius_front", "radius_back"):
        radius = abs(getattr(lens, key))
        if 0 < radius < half:
            what = f"a face of radius {radius:g} m cannot be {lens.diameter:g} m wide"
            remedy = f"lower `diameter` to at most {2 * radius:g}, or raise `{key}`"
            findings.error(what, remedy, "objects", index, "lens", key)
            return
    rim = lens.thickness - _sag(lens.radius_front, half) - _sag(lens.radius_back, half)
    if rim < 0:
        what = f"the faces cross before the rim, where the thickness would be {rim:.4g} m"
        remedy = f"raise `thickness` to at least {lens.thickness - rim:.6g}, or lower `diameter`"
        findings.error(what, remedy, "objects", index, "lens", "thickness")


def _sag(radius: float, half_width: float) -> float:
    """How far a face has dropped from its vertex at ``half_width``; negative for concave faces."""
    if radius == 0:
        return 0.0
    size = abs(radius)
    sag = half_width**2 / (size + math.sqrt((size - half_width) * (size + half_width)))
    return math.copysign(sag, radius)


# --- prism ----------------------------------------------------------------------------------------------------------


def _check_profile(findings: Findings, index: int, prism: Prism) -> None:
    """A profile's edges may meet only where they follow each other, and it must enclose an area."""
    if prism.profile is None:
        return
    corners, path = prism.profile, ("objects", index, "prism", "profile")
    if len(corners) > 1000:
        findings.error(f"the profile has {len(corners)} corners", "use at most 1000, or a mesh", *path)
        return
    edges = list(zip(corners, corners[1:] + corners[:1], strict=True))
    if any(start == end for start, end in edges):
        findings.error("the profile repeats a corner", "give each corner once; the last edge closes by itself", *path)
        return
    for first in range(len(edges)):
        for second in range(first + 2, len(edges)):
            if (first, second) != (0, len(edges) - 1) and _cross_each_other(*edges[first], *edges[second]):
                what = f"the profile crosses itself: edges {first + 1} and {second + 1} meet"
                findings.error(what, "put the corners in order around the outline", *path)
                return
    if sum(a[0] * b[1] - b[0] * a[1] for a, b in edges) == 0:
        findings.error("the profile encloses no area", "move a corner off the line of the others", *path)


Corner = tuple[float, float]


def _cross_each_other(a: Corner, b: Corner, c: Corner, d: Corner) -> bool:
    """Whether the segments ab and cd share a point."""
    turns = (_turn(a, b, c), _turn(a, b, d), _turn(c, d, a), _turn(c, d, b))
    if turns[0] * turns[1] < 0 and turns[2] * turns[3] < 0:
        return True
    ends = ((a, b, c, turns[0]), (a, b, d, turns[1]), (c, d, a, turns[2]), (c, d, b, turns[3]))
    return any(turn == 0 and _between(p, q, r) for p, q, r, turn in ends)


def _turn(a: Corner, b: Corner, c: Corner) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _between(a: Corner, b: Corner, c: Corner) -> bool:
    """Whether c, known to be on the line ab, lies between a and b."""
    return all(min(p, q) <= r <= max(p, q) for p, q, r in zip(a, b, c, strict=True))


# --- files ----------------------------------------------------------------------------------------------------------


def _check_mesh(findings: Findings, index: int, mesh: Mesh) -> None:
    path = ("objects", index, "mesh", "file")
    if Path(mesh.file).suffix.lower() not in MESH_ENDINGS:
        findings.error(f"`{mesh.file}` is neither PLY nor OBJ", "give a file that ends in .ply or .obj", *path)
    elif (problem := file_problem(findings, mesh.file)) is not None:
        findings.error(problem, "paths are relative to the scene file; check this one", *path)


def file_problem(findings: Findings, file: str) -> str | None:
    """What is wrong with a file that a scene names, None when it can be read."""
    found = findings.loaded.path.parent / file
    try:
        if found.is_dir():
            return f"`{file}` is a folder"
        if not found.is_file():
            return f"there is no file `{file}`"
        if found.stat().st_size == 0:
            return f"the file `{file}` is empty"
    except (OSError, ValueError) as error:
        return f"the file `{file[:60]}` cannot be read ({getattr(error, 'strerror', None) or error})"
    return None
