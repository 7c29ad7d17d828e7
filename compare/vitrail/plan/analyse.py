"""From a scene to its plan: every phenomenon of the vocabulary, required or not, with the evidence."""

from __future__ import annotations

from vitrail.plan.evidence import requirement
from vitrail.plan.facts import facts_of
from vitrail.plan.plan import Plan
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
