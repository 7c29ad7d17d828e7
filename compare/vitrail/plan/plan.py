"""The plan: what a scene requires, phenomenon by phenomenon, with evidence and cost."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from vitrail.base.phenomenon import Phenomenon


@dataclass(frozen=True)
class Requirement:
    """One phenomenon: whether it must be modelled, why (or why not), and what it costs.

    ``left_out`` says what is present but stays below the stated error, with its size.
    """

    required: bool
    evidence: tuple[str, ...]
    cost: str
    left_out: tuple[str, ...] = ()


@dataclass(frozen=True)
class CausticPath:
    """light -> specular object -> diffuse receiver -> camera, by names."""

    light: str
    specular: str
    receiver: str


@dataclass(frozen=True)
class Chain:
    """The longest specular chain; ``proven`` by geometry, else the limits of the scene itself."""

    reflections: int
    transmissions: int
    proven: bool
    reason: str


@dataclass(frozen=True)
class Plan:
    """Requirements by phenomenon, and the facts that back ends and budget take from the analysis."""

    entries: Mapping[Phenomenon, Requirement]
    caustic_paths: tuple[CausticPath, ...]
    chain: Chain
    warnings: tuple[str, ...] = field(default=())

    def with_plans(self, others: Sequence[Plan]) -> Plan:
        """What this plan or any of ``others`` requires: the same scene is looked at by several cameras."""
        plans = (self, *others)
        entries = {
            phenomenon: next((plan.entries[phenomenon] for plan in plans if plan.requires(phenomenon)), entry)
            for phenomenon, entry in self.entries.items()
        }
        paths = tuple(dict.fromkeys(path for plan in plans for path in plan.caustic_paths))
        longest = max((plan.chain for plan in plans), key=lambda chain: (chain.transmissions, chain.reflections))
        chain = replace(longest, reflections=max(plan.chain.reflections for plan in plans))
        return replace(self, entries=entries, caustic_paths=paths, chain=chain)

    def requires(self, phenomenon: Phenomenon) -> bool:
        return self.entries[phenomenon].required

    def flags(self) -> dict[str, bool]:
        """Every phenomenon by name, for the lowered scene."""
        return {phenomenon.value: self.requires(phenomenon) for phenomenon in Phenomenon}
