"""From a scene to its plan: every phenomenon of the vocabulary, required or not, with the evidence."""

from __future__ import annotations

from dataclasses import replace

from vitrail.plan.evidence import could_occur, requirement
from vitrail.plan.facts import facts_of
from vitrail.plan.plan import Chain, Plan, Requirement
from vitrail.scene.model import Scene
from vitrail.scene.phenomenon import Phenomenon


def analyse(scene: Scene) -> Plan:
    """What the scene requires; for any scene that passed ``check``."""
    facts = facts_of(scene)
    return Plan(
        entries={phenomenon: requirement(phenomenon, facts) for phenomenon in Phenomenon},
        caustic_paths=facts.paths,
        chain=facts.chain,
    )


def everything(scene: Scene) -> Plan:
    """The plan that leaves nothing out: all that the scene's materials could do, at the full depth the scene allows.

    Rendering it must give the same image as the plan of ``analyse``; it only takes longer.
    """
    limits = scene.transport
    entries = {phenomenon: Requirement(*could_occur(phenomenon, scene), cost="") for phenomenon in Phenomenon}
    full = Chain(limits.max_reflections, limits.max_transmissions, False, "the limits of the scene")
    return replace(analyse(scene), entries=entries, chain=full)
