"""What is to be translated, in one value."""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.world import World
from vitrail.lower.povray.refusals.refusal import Refusals
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Settings
from vitrail.scene.model import Scene


@dataclass(frozen=True)
class Asked:
    """The world of a scene without what its plan leaves out, the plan, the settings, and where to complain."""

    world: World
    plan: Plan
    settings: Settings
    refusals: Refusals

    @property
    def scene(self) -> Scene:
        return self.world.scene

    @property
    def has_caustic(self) -> bool:
        return self.plan.requires(Phenomenon.CAUSTIC)
