"""Evidence for light that arrives by way of others: caustics and interreflection."""

from __future__ import annotations

from vitrail.plan.convexity import never_meets_itself
from vitrail.plan.evidence.words import LONGEST_LIST, colour, needed, not_needed
from vitrail.plan.facts import Facts
from vitrail.plan.intercepted_power import intercepted_power
from vitrail.plan.plan import Requirement
from vitrail.plan.stated_error import SHARE
from vitrail.scene.model import Ambient


def caustic(facts: Facts) -> Requirement:
    """Every path light -> specular object -> diffuse receiver -> camera."""
    if not facts.paths:
        return not_needed(_why_no_caustic(facts))
    lights = {path.light for path in facts.paths}
    casters = {path.specular for path in facts.paths}
    cost = f"one photon pass aimed at {len(casters)} object(s) from {len(lights)} light(s), and a gathering a sample"
    pairs = dict.fromkeys((path.light, path.specular) for path in facts.paths)
    return needed([_paths(facts, light, caster) for light, caster in pairs], cost)


def indirect_light(facts: Facts) -> Requirement:
    """Light from one diffuse surface to the next, where the scene asks for it and there are two."""
    indirect = facts.scene.transport.indirect
    if isinstance(indirect, Ambient):
        return needed(
            (f"`transport.indirect` asks for a constant irradiance of {colour(indirect.ambient)} W/m2",), "none"
        )
    if indirect == "none":
        return not_needed("`transport.indirect` is none")
    if not facts.diffuse_seen:
        return not_needed("nothing diffuse can be seen")
    if len(facts.scene.objects) == 1 and never_meets_itself(facts.world, facts.scene.objects[0]):
        return not_needed(f"`{facts.scene.objects[0].name}` is alone and never lights itself")
    brightest = max(max(facts.scene.material_of(item).diffuse_peak) for item in facts.scene.objects)
    if brightest < SHARE:
        return not_needed("", (f"surfaces scatter at most {brightest:.2g} of the light, below the stated {SHARE:g}",))
    gain = f"up to {brightest / (1 - brightest):.3g} times the direct light" if brightest < 1 else "without limit"
    evidence = f"surfaces scatter up to {brightest:.3g}: interreflection in a closed room adds {gain}"
    return needed((evidence,), "a global photon map, and a final gather at every sample")


def _paths(facts: Facts, light_name: str, caster_name: str) -> str:
    """The paths from one light by way of one object, with the power that may take them."""
    scene = facts.scene
    light = next(item for item in scene.lights if item.name == light_name)
    caster = next(item for item in scene.objects if item.name == caster_name)
    power_w = intercepted_power(light, facts.world.bounds(caster))
    power = "" if power_w is None else f" (at most {power_w:.3g} W)"
    found = [path.receiver for path in facts.paths if (path.light, path.specular) == (light_name, caster_name)]
    receivers = ", ".join(f"`{name}`" for name in found[:LONGEST_LIST])
    more = f" and {len(found) - LONGEST_LIST} more" if len(found) > LONGEST_LIST else ""
    return f"`{light_name}` -> `{caster_name}`{power} -> {receivers}{more} -> camera"


def _why_no_caustic(facts: Facts) -> str:
    if not any(facts.material(item).is_specular for item in facts.scene.objects):
        return "nothing mirrors or refracts"
    if not facts.lights:
        return "there is no light"
    if not facts.diffuse_seen:
        return "no diffuse surface can be seen that could show one"
    return "no light reaches a specular object that could send it to a seen diffuse surface"
