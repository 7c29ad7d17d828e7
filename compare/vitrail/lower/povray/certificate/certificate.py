"""What the translation to POV-Ray changes, and by how much: a list of laws, each with its residual.

A residual is relative to the phenomenon's own size unless its unit says otherwise. ``bound`` adds up what may act
together on one phenomenon; the judge takes no smaller deviation between the engines for a disagreement. Blurs of
several materials do not add up: squares of widths do, so the whole is off by no more than the worst of them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from vitrail.base.certificate_entry import CertificateEntry
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.record import JsonObject
from vitrail.scene.model import Scene

RELATIVE = "relative"
IMAGE: Literal["image"] = "image"
"""The item of an entry about the image as it is written: it acts on all light that the image holds."""
HALF_FLOAT = 4.9e-4
"""Largest relative rounding of an 11-bit mantissa: half a step at its low end [P 6]."""


@dataclass(frozen=True)
class Named:
    """A part of the scene, by the name that its author gave."""

    kind: Literal["object", "material", "light"]
    name: str

    def __str__(self) -> str:
        return f"`{self.name}`"


@dataclass(frozen=True)
class CutBy:
    """A solid and the one of higher priority that takes room from it."""

    lower: Named
    higher: Named

    def __str__(self) -> str:
        return f"{self.lower} cut by {self.higher}"


Item = Named | CutBy | Literal["image", "scene", "path", "photons", "kernel", "radiosity"]
"""What an entry is about: a part of the scene, or something that all of it shares."""


def the_object(scene: Scene, index: int) -> Named:
    return Named("object", scene.objects[index].name)


def the_light(scene: Scene, index: int) -> Named:
    return Named("light", scene.lights[index].name)


def the_material(name: str) -> Named:
    return Named("material", name)


@dataclass(frozen=True)
class Entry:
    """One law of the scene and the law that stands for it in POV-Ray."""

    phenomenon: Phenomenon
    item: Item
    source_law: str
    target_law: str
    residual: float
    unit: str
    reason: str

    @property
    def record(self) -> CertificateEntry:
        """The entry as it is written, its item by name."""
        return CertificateEntry(
            phenomenon=self.phenomenon,
            item=str(self.item),
            source_law=self.source_law,
            target_law=self.target_law,
            residual=self.residual,
            unit=self.unit,
            reason=self.reason,
        )


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

    @property
    def records(self) -> tuple[CertificateEntry, ...]:
        """The entries for a file, a report or a run record."""
        return tuple(each.record for each in self.entries)

    def as_json(self) -> list[JsonObject]:
        """The records as plain values."""
        return [record.model_dump(mode="json") for record in self.records]
