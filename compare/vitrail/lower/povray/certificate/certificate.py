"""What the translation to POV-Ray changes, and by how much: a list of laws, each with its residual.

A residual is relative to the phenomenon's own size unless its unit says otherwise. ``bound`` adds up what may act
together on one phenomenon; the judge takes no smaller deviation between the engines for a disagreement. Blurs of
several materials do not add up: squares of widths do, so the whole is off by no more than the worst of them.
"""

from __future__ import annotations

import re
from dataclasses import asdict, dataclass, replace
from typing import Any

from vitrail.base.phenomenon import Phenomenon
from vitrail.scene.model import Scene

RELATIVE = "relative"
IMAGE = "image"
"""The item of an entry about the image as it is written: it acts on all light that the image holds."""
HALF_FLOAT = 4.9e-4
"""Largest relative rounding of an 11-bit mantissa: half a step at its low end [P 6]."""
IDENTIFIER = re.compile(r"\b([OML])(\d+)\b")
"""What an object, a material or a light is called in the SDL: its kind and its number from 1."""


@dataclass(frozen=True)
class Entry:
    """One law of the scene and the law that stands for it in POV-Ray."""

    phenomenon: Phenomenon
    item: str
    source_law: str
    target_law: str
    residual: float
    unit: str
    reason: str


@dataclass(frozen=True)
class Certificate:
    """Every approximation of one translation."""

    entries: tuple[Entry, ...]

    def bound(self, phenomenon: Phenomenon, whole_over_light: float = 1.0) -> float:
        """The sum of the relative residuals that act on a phenomenon; other units are not added.

        ``whole_over_light``: how many times larger the radiance in the image is than the light of the phenomenon, where
        that is a difference; what rounds the image counts as many times.
        """
        acting = [
            replace(each, residual=each.residual * whole_over_light) if each.item == IMAGE else each
            for each in self.entries
            if each.phenomenon is phenomenon and each.unit == RELATIVE
        ]
        if phenomenon is not Phenomenon.ROUGHNESS:
            return sum(each.residual for each in acting)
        worst: dict[str, float] = {}
        for each in acting:
            worst[each.target_law] = max(each.residual, worst.get(each.target_law, 0.0))
        return sum(worst.values())

    def of(self, phenomenon: Phenomenon) -> tuple[Entry, ...]:
        return tuple(each for each in self.entries if each.phenomenon is phenomenon)

    def as_records(self) -> list[dict[str, Any]]:
        """Plain values for a report or a run record."""
        return [{**asdict(each), "phenomenon": each.phenomenon.value} for each in self.entries]


def with_names(entries: tuple[Entry, ...], scene: Scene) -> Certificate:
    """The certificate, each item and reason in the names its reader gave: `ball` for O2."""
    names = {
        "O": [item.name for item in scene.objects],
        "M": list(scene.materials),
        "L": [light.name for light in scene.lights],
    }

    def told(text: str) -> str:
        return IDENTIFIER.sub(lambda found: f"`{names[found[1]][int(found[2]) - 1]}`", text)

    return Certificate(tuple(replace(each, item=told(each.item), reason=told(each.reason)) for each in entries))
