"""Evidence for what turns light a little: dispersion and roughness, measured in pixels on the screen."""

from __future__ import annotations

import math
from collections.abc import Callable

from vitrail.plan.evidence.words import degrees, needed, not_needed, pixels
from vitrail.plan.facts import Facts
from vitrail.plan.lever import Lever
from vitrail.plan.plan import Requirement
from vitrail.plan.stated_error import PIXELS
from vitrail.scene.model import Ggx, Material, Object

FACES = 2
"""Faces that turn the light at a body: it gets in and out."""

GGX_TAIL = 10.0
"""tan of the angle that 99 % of microfacets stay below, over alpha: alpha^2 / (alpha^2 + x^2) = 1/100 [W07 eq. 33]."""


def dispersion(facts: Facts) -> Requirement:
    """Dispersive glass on a path that the camera sees, unless its colours part by less than the stated error."""
    items = [item for item in facts.active_glass if facts.material(item).is_dispersive]
    if not items:
        return not_needed("no dispersive glass is on a path to the camera")
    cost = f"each path through it splits once into {len(facts.bands)} bands"
    by_camera = facts.scene.paper.disperse_camera
    return _by_pixels(facts, items, cost, by_camera, lambda item: _spread(facts, item), "parts colours")


def roughness(facts: Facts) -> Requirement:
    """Rough faces on a path that the camera sees, unless they blur by less than the stated error."""
    items = [item for item in facts.active if facts.material(item).roughness != 0]
    if not items:
        return not_needed("every face that mirrors or refracts light on its way to the camera is smooth")
    cost = f"{facts.scene.paper.rough_samples} ray(s) for one at every rough face"
    return _by_pixels(facts, items, cost, True, lambda item: _blur(facts.material(item)), "blurs")


def _by_pixels(
    facts: Facts,
    items: list[Object],
    cost: str,
    by_camera: bool,
    turn: Callable[[Object], tuple[float, float, str]],
    verb: str,
) -> Requirement:
    """Decide by the largest turn on the screen; ``turn`` gives a typical angle, the largest one, and its cause."""
    evidence, left_out = [], []
    for item in items:
        typical, most, cause = turn(item)
        levers = facts.levers(item, by_camera)
        if not levers:
            continue
        most_px = max(most * lever.most_px for lever in levers)
        if most_px < PIXELS:
            left_out.append(
                f"`{item.name}` ({cause}) {verb} by at most {most_px:.2g} px, below the stated {PIXELS:g} px"
            )
        else:
            evidence.append(f"`{item.name}` ({item.material}, {cause}) {verb} by {_on_screen(typical, levers)}")
    if not evidence:
        return not_needed("the camera sees none of it", left_out)
    return needed(evidence, cost, left_out)


def _on_screen(turn: float, levers: list[Lever]) -> str:
    """The angle, and the pixels it makes through the glass itself and on the receiver where it makes most."""
    receivers = [lever for lever in levers if not lever.through]
    shown = [lever for lever in levers if lever.through]
    shown += [max(receivers, key=lambda lever: lever.typical_px)] if receivers else []
    return f"{degrees(turn)}, about " + " and ".join(f"{pixels(turn * e.typical_px)} {e.where}" for e in shown)


def _spread(facts: Facts, item: Object) -> tuple[float, float, str]:
    """Angles between the outermost bands: (n_high - n_low) as for a thin prism of 1 rad; at most what the law of sines
    allows, sin(turned) = n sin(t) over the range of n, at each face."""
    low, high = facts.indices(item)
    most = FACES * math.acos(max(-1.0, 1 - (high - low) / low))
    return high - low, most, f"n {low:.5g} to {high:.5g}"


def _blur(material: Material) -> tuple[float, float, str]:
    """Mean and largest deflection of one face. [S eq. 8]: [O 1.3]; GGX: alpha, and the angle of 99 % mirrored."""
    if isinstance(material.roughness, Ggx):
        alpha = material.roughness.ggx
        return math.atan(alpha), FACES * 2 * math.atan(GGX_TAIL * alpha), f"alpha {alpha:g}"
    value = material.roughness
    return math.atan(mean_tangent(value)), FACES * math.atan(value / (2 - value)), f"lambda {value:g}"


def mean_tangent(roughness: float) -> float:
    """Mean tan of the turn by [S eq. 8]: (pi/4)(2/l)(-ln(1 - l/2) - l/2), by its series where that cancels [O 1.3]."""
    half = roughness / 2
    if half < 1e-4:
        return math.pi / 4 * half * (0.5 + half / 3)
    return math.pi / 4 / half * (-math.log1p(-half) - half)
