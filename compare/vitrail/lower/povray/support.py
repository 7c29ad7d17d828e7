"""What this back end refuses before it translates anything, all of it at once."""

from __future__ import annotations

from vitrail.lower.povray.refusal import NotTranslatable, Refusals
from vitrail.plan.budget import Settings
from vitrail.plan.plan import Plan
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.model import Scene
from vitrail.scene.phenomenon import Phenomenon


def refuse_unsupported(scene: Scene, plan: Plan, settings: Settings, refusals: Refusals) -> None:
    """Raises NotTranslatable with one diagnostic a place."""
    found: list[Diagnostic] = []
    for name, material in scene.materials.items():
        if material.is_specular and material.roughness != 0 and plan.requires(Phenomenon.ROUGHNESS):
            what = "roughness has no POV-Ray counterpart here yet"
            found.append(refusals.at(what, "drop `roughness`", "materials", name, "roughness"))
    if scene.transport.indirect == "photons" and plan.requires(Phenomenon.INDIRECT_LIGHT):
        what = "indirect light by photons has no POV-Ray counterpart here yet"
        found.append(refusals.at(what, "use `indirect: {ambient: ...}` or none", "transport", "indirect"))
    if found:
        raise NotTranslatable(found)
