"""A scene needs light, from places that light can leave."""

from __future__ import annotations

from vitrail.base.vector import Vec, length
from vitrail.check.findings import Findings
from vitrail.check.skies import check_sky
from vitrail.geometry.lamp import place_of
from vitrail.scene.model import Ambient, Area, Checker, Environment, Light, Material, Plane

TOUCH = 1e-9
"""A lamp closer to a surface than this share of its distance from the origin counts as on it."""


def check_lights(findings: Findings) -> None:
    """Refuse a scene without light; report dark lamps, lamps inside or on objects, and glow that lights nothing."""
    scene = findings.scene
    emitting = [name for name, material in scene.materials.items() if _glows(material)]
    if not scene.lights and not emitting and not _is_ambient(findings):
        remedy = "add one under `lights`, or give a material `emission`"
        findings.error("the scene has no light", remedy, "lights")
    _check_glow(findings, emitting)
    for index, light in enumerate(scene.lights):
        if max(_strength(light)) == 0:
            what = f"the light `{light.name}` is dark"
            findings.warning(what, "raise its value or remove it", "lights", index, light.emitter.key)
        if isinstance(light.emitter, Environment) and light.emitter.file is not None:
            check_sky(findings, index, light.emitter.file)
        _check_place(findings, index, light)
    if scene.lights:
        _check_planes(findings)


def _check_planes(findings: Findings) -> None:
    """Photons are aimed at what is finite, and at an infinite plane where it mirrors that: planes alone get none."""
    scene = findings.scene
    if not all(isinstance(item.shape, Plane) for item in scene.objects):
        return
    lit = [item.name for item in scene.objects if scene.material_of(item).is_diffuse]
    for index, item in enumerate(scene.objects):
        if lit and scene.material_of(item).is_specular:
            light = f"light that reaches `{lit[0]}` by way of `{item.name}`"
            what = f"{light} is not followed: all objects are infinite planes"
            remedy = "write it as a box or rectangle, as wide as the light needs"
            findings.error(what, remedy, "objects", index, "plane")


def _glows(material: Material) -> bool:
    match material.emission:
        case None:
            return False
        case Checker() as pattern:
            return any(max(color) > 0 for color in pattern.checker.colors)
        case color:
            return max(color) > 0


def _is_ambient(findings: Findings) -> bool:
    indirect = findings.scene.transport.indirect
    return isinstance(indirect, Ambient) and max(indirect.ambient) > 0


def _check_glow(findings: Findings, emitting: list[str]) -> None:
    """Emission is seen but lights nothing: warn where a diffuse surface waits for its light in vain."""
    scene = findings.scene
    if scene.lights or _is_ambient(findings):
        return
    waiting = [item.name for item in scene.objects if scene.material_of(item).is_diffuse]
    for name in emitting:
        if waiting:
            what = f"the emission of `{name}` is seen but lights nothing, and `{waiting[0]}` has no light to scatter"
            findings.warning(
                what, "add an `area` light of the same radiance in its place", "materials", name, "emission"
            )


def _strength(light: Light) -> Vec:
    """The number that says how much light there is; an environment image counts as light."""
    emitter = light.emitter
    for key in ("irradiance", "intensity", "radiance"):
        value = getattr(emitter, key, None)
        if value is not None:
            return value
    return (1.0, 1.0, 1.0)


def _check_place(findings: Findings, index: int, light: Light) -> None:
    """A lamp on a surface has no defined side; one inside something opaque lights nothing."""
    place, world = place_of(light), findings.world_without_meshes
    if place is None:
        return
    path = ("lights", index, light.emitter.key, _place_key(light))
    for other, (item, solid) in enumerate(zip(world.scene.objects, world.solids, strict=True)):
        if solid.distance(place) <= TOUCH * max(1e-300, length(place)):
            what = f"the light `{light.name}` lies on the surface of `{item.name}`"
            remedy = "move it off the surface, by a millimetre for example"
            report = findings.warning if isinstance(light.emitter, Area) else findings.error
            report(what, remedy, *path)
        elif not world.material(other).is_transmissive and solid.contains(place) and not world.is_room(other):
            what = f"the light `{light.name}` is inside the opaque `{item.name}` and lights nothing outside"
            findings.warning(what, "move it out", *path)


def _place_key(light: Light) -> str:
    """The key that says where a lamp is."""
    if isinstance(light.emitter, Area):
        return light.emitter.shape.key
    return "position"
