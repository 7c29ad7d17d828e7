"""Evidence for what the inside and the faces of glass do: bend, trap, colour and absorb light."""

from __future__ import annotations

import math

from vitrail.plan.evidence.words import colour, degrees, needed, not_needed
from vitrail.plan.facts import Facts
from vitrail.plan.plan import Requirement
from vitrail.plan.stated_error import SHARE
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.model import Material, Object

NO_GLASS = "no glass is on a path to the camera"


def refraction(facts: Facts) -> Requirement:
    """Glass that is seen, or that casts light that is seen."""
    evidence = [f"`{item.name}` ({item.material}) {_bends(facts, item)}" for item in facts.active_glass]
    if not evidence:
        return not_needed(NO_GLASS)
    return needed(evidence, f"one more ray a face, up to {facts.chain.transmissions} in a row")


def total_internal_reflection(facts: Facts) -> Requirement:
    """Glass inside which light may meet a face beyond the critical angle; refused only by proof."""
    if not facts.active_glass:
        return not_needed(NO_GLASS)
    if facts.chain.proven and facts.chain.reflections == 0:
        return not_needed(facts.chain.reason)
    evidence = [
        f"`{item.name}` ({item.material}) {_traps(max(facts.indices(item)))}"
        for item in facts.active_glass
        if facts.indices(item) != (1.0, 1.0)
    ]
    if not evidence:
        return not_needed("all glass has index 1")
    return needed(evidence, "chains as long as the light is trapped")


def coloured_transmission(facts: Facts) -> Requirement:
    """Glass that treats the channels differently, at its faces or inside."""
    evidence = [
        f"`{item.name}` ({item.material}) {_colours(facts.material(item))}"
        for item in facts.active_glass
        if is_coloured(facts.material(item))
    ]
    if not evidence:
        return not_needed(
            "all glass on a path to the camera passes the channels alike" if facts.active_glass else NO_GLASS
        )
    return needed(evidence, "nothing beyond refraction")


def absorption(facts: Facts) -> Requirement:
    """Glass that takes light along the way; the longest straight way through it decides whether that shows."""
    evidence, left_out = [], []
    for item in facts.active_glass:
        longest_m = 2 * facts.world.bounds(item).radius_m
        taken = [1 - kept for kept in _kept(facts.material(item), longest_m)]
        if max(taken) == 0:
            continue
        if max(taken) < SHARE:
            left_out.append(f"`{item.name}` absorbs {max(taken):.2g} on its longest way, below the stated {SHARE:g}")
        elif math.isfinite(longest_m):
            kept = colour([1 - part for part in taken])
            evidence.append(f"`{item.name}` ({item.material}) keeps {kept} over its longest way, {longest_m:.3g} m")
        else:
            evidence.append(f"`{item.name}` ({item.material}) absorbs on a way without limit")
    if not evidence:
        return not_needed(
            "no glass on a path to the camera absorbs inside" if facts.active_glass else NO_GLASS, left_out
        )
    return needed(evidence, "one exponential a crossing", left_out)


def is_coloured(material: Material) -> bool:
    return len(set(material.transmission)) > 1 or len(set(absorption_per_m(material))) > 1


def _kept(material: Material, way_m: float) -> list[float]:
    """exp(-a d) per channel; 1 where a is 0, whatever the way [O 2.36]."""
    return [math.exp(-a * way_m) if a > 0 else 1.0 for a in absorption_per_m(material)]


def _bends(facts: Facts, item: Object) -> str:
    low, high = facts.indices(item)
    if (low, high) == (1.0, 1.0):
        return "lets light through unbent, index 1"
    return f"bends light, index {low:.6g}" + (f" to {high:.6g}" if high > low else "")


def _traps(index: float) -> str:
    """The critical angle, on the side where the light is slower."""
    if index > 1:
        return f"mirrors totally inside beyond {degrees(math.asin(1 / index))}"
    return f"mirrors totally outside beyond {degrees(math.asin(index))}"


def _colours(material: Material) -> str:
    if len(set(material.transmission)) == 1:
        return f"absorbs {colour(absorption_per_m(material))} per m"
    twice = [share * share for share in material.transmission]
    return f"passes {colour(material.transmission)} at each face, {colour(twice)} through two"
