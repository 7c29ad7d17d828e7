"""Glass must enclose something, and each point inside glass must know which glass rules there."""

from __future__ import annotations

import itertools

from vitrail.base.changed import changed
from vitrail.check.findings import Findings
from vitrail.geometry.inside import is_solid
from vitrail.geometry.overlap import overlap
from vitrail.scene.model import Object, Plane


def check_solids(findings: Findings) -> None:
    """Refuse glass without an inside, and overlapping glass without different priorities; warn of cut-through glass."""
    scene = findings.with_full_paths
    glasses: list[tuple[int, Object]] = []
    for index, item in enumerate(scene.objects):
        if not scene.material_of(item).is_transmissive:
            continue
        if index in findings.broken_objects:
            continue
        if is_solid(item):
            glasses.append((index, item))
        else:
            what = f"`{item.name}` transmits, but a {item.shape.key} encloses nothing for light to travel in"
            remedy = "use a solid, for example a thin `box`"
            findings.error(what, remedy, "objects", index, item.shape.key)
    for first, second in itertools.combinations(glasses, 2):
        _check_priority(findings, first, second)
    for index, item in enumerate(scene.objects):
        if isinstance(item.shape, Plane) and not scene.material_of(item).is_transmissive:
            _check_cut(findings, index, item, glasses)


def _check_priority(findings: Findings, first: tuple[int, Object], second: tuple[int, Object]) -> None:
    """Two glasses that share volume need different priorities; the higher one rules there."""
    (_, one), (index, two) = first, second
    if (one.priority or 0) != (two.priority or 0):
        return
    found = overlap(one, two)
    if not found:
        return
    if one.priority is not None and two.priority is not None:
        given = f"both have priority {two.priority}"
    else:
        given = "neither has a priority above 0"
    what = f"`{two.name}` overlaps `{one.name}` by {found.depth_m:.3g} m and {given}"
    remedy = "give the one that rules in the shared part the higher `priority`, or part them"
    findings.error(what, remedy, "objects", index)


def _check_cut(findings: Findings, index: int, plane: Object, glasses: list[tuple[int, Object]]) -> None:
    """An opaque plane through glass is legal, but mostly a glass that has sunk into the floor.

    Glass that fills a half space has no other end than such a plane: a sea over its bed.
    """
    for _, glass in glasses:
        if isinstance(glass.shape, Plane):
            continue
        found = overlap(plane, glass)
        if found and not _is_below(plane, glass):
            what = f"the plane `{plane.name}` cuts `{glass.name}`, which reaches {found.depth_m:.3g} m beyond it"
            findings.warning(what, "move one of them unless the cut is meant", "objects", index, "plane")


def _is_below(plane: Object, glass: Object) -> bool:
    """Whether the glass lies wholly on the back of the plane, where it is not cut."""
    shape = plane.shape
    assert isinstance(shape, Plane)
    normal = (-shape.normal[0], -shape.normal[1], -shape.normal[2])
    flipped = changed(plane, shape=changed(shape, normal=normal))
    return not overlap(flipped, glass)
