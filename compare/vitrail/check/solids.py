"""Glass must enclose something, and each point inside glass must know which glass rules there."""

from __future__ import annotations

from vitrail.check.findings import Findings
from vitrail.geometry.near_pairs import near_pairs
from vitrail.geometry.overlap import overlap
from vitrail.geometry.shapes.flat import PlacedPlane
from vitrail.geometry.world import World


def check_solids(findings: Findings) -> None:
    """Refuse glass without an inside, and overlapping glass without different priorities; warn of cut-through glass."""
    world = findings.world
    glasses: list[int] = []
    for index, item in enumerate(world.scene.objects):
        if not world.material(index).is_transmissive:
            continue
        if index in findings.broken_objects:
            continue
        if world.solids[index].is_closed:
            glasses.append(index)
        else:
            what = f"`{item.name}` transmits, but a {item.shape.key} encloses nothing for light to travel in"
            remedy = "use a solid, for example a thin `box`"
            findings.error(what, remedy, "objects", index, item.shape.key)
    for one, other in near_pairs([world.solids[glass].bounds for glass in glasses]):
        _check_priority(findings, world, glasses[one], glasses[other])
    for index, solid in enumerate(world.solids):
        if isinstance(solid, PlacedPlane) and not world.material(index).is_transmissive:
            _check_cut(findings, world, index, solid, glasses)


def _check_priority(findings: Findings, world: World, first: int, second: int) -> None:
    """Two glasses that share volume need different priorities; the higher one rules there."""
    if world.priority(first) != world.priority(second):
        return
    found = world.overlap(first, second)
    if not found:
        return
    one, two = world.scene.objects[first], world.scene.objects[second]
    if one.priority is not None and two.priority is not None:
        given = f"both have priority {two.priority}"
    else:
        given = "neither has a priority above 0"
    what = f"`{two.name}` overlaps `{one.name}` by {found.depth_m:.3g} m and {given}"
    remedy = "give the one that rules in the shared part the higher `priority`, or part them"
    findings.error(what, remedy, "objects", second)


def _check_cut(findings: Findings, world: World, index: int, plane: PlacedPlane, glasses: list[int]) -> None:
    """An opaque plane through glass is legal, but mostly a glass that has sunk into the floor.

    Glass that fills a half space has no other end than such a plane: a sea over its bed.
    """
    for glass in glasses:
        if isinstance(world.solids[glass], PlacedPlane):
            continue
        found = world.overlap(index, glass)
        # Glass wholly on the back of the plane is not cut.
        if found and overlap(plane.turned(), world.solids[glass]):
            names = world.scene.objects[index].name, world.scene.objects[glass].name
            what = f"the plane `{names[0]}` cuts `{names[1]}`, which reaches {found.depth_m:.3g} m beyond it"
            findings.warning(what, "move one of them unless the cut is meant", "objects", index, "plane")
