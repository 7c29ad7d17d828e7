"""From a scene to its plan: every phenomenon of the vocabulary, required or not, with the evidence."""

from __future__ import annotations

from dataclasses import replace

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.world import World
from vitrail.plan.evidence.requirement import requirement
from vitrail.plan.facts import facts_of
from vitrail.plan.plan import Chain, Plan, Requirement
from vitrail.plan.possible import could_occur
from vitrail.scene.model import Scene


def analyse(world: World) -> Plan:
    """What the scene requires; for any scene that passed ``check``."""
    scene = world.scene
    facts = facts_of(world)
    entries = {phenomenon: requirement(phenomenon, facts) for phenomenon in Phenomenon}
    left_out = [warning for entry in entries.values() for warning in entry.left_out]
    return Plan(
        entries=entries,
        caustic_paths=facts.paths,
        chain=facts.chain,
        warnings=(*left_out, *_observed_in_vain(scene, entries)),
    )


def everything(world: World) -> Plan:
    """The plan that leaves nothing out: all that the scene's materials could do, at the full depth the scene allows.

    Rendering it must give the same image as the plan of ``analyse``; it only takes longer.
    """
    scene = world.scene
    limits = scene.transport
    reason = ("everything is on, as far as the scene's materials go",)
    entries = {phenomenon: Requirement(could_occur(phenomenon, scene), reason, "") for phenomenon in Phenomenon}
    full = Chain(limits.max_reflections, limits.max_transmissions, False, "the limits of the scene")
    return replace(analyse(world), entries=entries, chain=full, warnings=())


def _observed_in_vain(scene: Scene, entries: dict[Phenomenon, Requirement]) -> list[str]:
    """Observations of something that the scene cannot show."""
    return [
        f"`{observation.name}` observes {observation.phenomenon.value}, which the scene does not show:"
        f" {entries[observation.phenomenon].evidence[0]}"
        for observation in scene.observe
        if not entries[observation.phenomenon].required
    ]
