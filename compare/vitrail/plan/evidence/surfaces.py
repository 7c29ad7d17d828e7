"""Evidence for what opaque faces do: scatter and mirror."""

from __future__ import annotations

from vitrail.plan.evidence.words import colour, needed, not_needed
from vitrail.plan.facts import Facts
from vitrail.plan.plan import Requirement
from vitrail.plan.stated_error import SHARE
from vitrail.scene.model import Material, Object


def diffusion(facts: Facts) -> Requirement:
    """Surfaces that scatter light or glow, and may be seen; a sky that is seen counts too."""
    evidence = [
        f"`{item.name}` ({item.material}) {_what_it_does(facts.material(item))}"
        for item in facts.seen
        if facts.material(item).is_diffuse or facts.material(item).emission is not None
    ]
    evidence += [
        f"`{light.name}` is the sky behind everything" for light in facts.lights if light.emitter.key == "environment"
    ]
    if not evidence:
        return not_needed("nothing that scatters light or glows can be seen")
    return needed(evidence, f"one ray a sample and light ({len(facts.lights)})")


def reflection(facts: Facts) -> Requirement:
    """Faces that mirror: a share r, or Fresnel's."""
    mirrors = [item for item in facts.active if is_mirroring(facts.material(item))]
    weak = [item for item in mirrors if is_weak_mirror(facts.material(item))]
    left_out = [
        f"`{item.name}` mirrors {max(facts.material(item).reflection):.2g} of the light, below the stated {SHARE:g}"
        for item in weak
    ]
    evidence = [f"`{item.name}` ({item.material}) {_mirrors(facts, item)}" for item in mirrors if item not in weak]
    if not evidence:
        return not_needed("nothing that mirrors is on a path to the camera", left_out)
    return needed(evidence, f"one more ray a face, up to {facts.chain.reflections} in a row", left_out)


def is_mirroring(material: Material) -> bool:
    return max(material.reflection) > 0 or (material.fresnel and material.is_transmissive)


def is_weak_mirror(material: Material) -> bool:
    """A mirror whose light stays below the stated error."""
    return not material.fresnel and 0 < max(material.reflection) < SHARE


def _what_it_does(material: Material) -> str:
    parts = []
    if material.is_diffuse:
        parts.append(f"scatters {colour(material.diffuse_peak)}")
    if material.emission is not None:
        parts.append("glows")
    return " and ".join(parts)


def _mirrors(facts: Facts, item: Object) -> str:
    """The mirrored share: r as given, or Fresnel's from normal incidence on."""
    material = facts.material(item)
    if not material.fresnel:
        return f"mirrors {colour(material.reflection)}"
    low, high = facts.indices(item)
    straight = [((index - 1) / (index + 1)) ** 2 for index in (low, high)]
    return f"mirrors {max(straight):.3g} at normal incidence by Fresnel, more at a slant"
