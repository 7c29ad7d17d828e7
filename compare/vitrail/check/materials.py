"""Materials that are consistent in themselves but not with the switches or objects of their scene."""

from __future__ import annotations

import math

from vitrail.check.findings import Findings
from vitrail.optics.dispersion import index_step, ior_position
from vitrail.optics.glass import abbe_index
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.model import Abbe, Material, Paper

_SHORTEST_NM, _LONGEST_NM = 380.0, 730.0


def check_materials(findings: Findings) -> None:
    """Report indices that dispersion drives to zero, idle settings, and materials that no object uses."""
    scene = findings.scene
    used = {item.material for item in scene.objects}
    for name, material in scene.materials.items():
        lowest = _lowest_index(material, scene.paper)
        if lowest is not None and lowest <= 0:
            what = f"its dispersion brings the refraction index of `{name}` down to {lowest:.4g}"
            findings.error(what, "an index is above 0; lower the dispersion", "materials", name, "dispersion")
        _check_absorption(findings, name, material)
        _check_idle_settings(findings, name, material)
        if name not in used:
            findings.warning(f"no object uses the material `{name}`", "remove it or use it", "materials", name)


def _check_absorption(findings: Findings, name: str, material: Material) -> None:
    """A distance next to nothing asks for an absorption that no number holds."""
    if material.attenuation is not None and not all(math.isfinite(each) for each in absorption_per_m(material)):
        what = f"a distance of {material.attenuation.distance:g} m makes the absorption of `{name}` infinite"
        findings.error(what, "make it longer, or the material opaque", "materials", name, "attenuation", "distance")


def _check_idle_settings(findings: Findings, name: str, material: Material) -> None:
    """Warn of settings that change nothing."""
    if material.fresnel and not material.is_specular:
        what = f"`fresnel` of `{name}` has no light to split"
        findings.warning(what, "add `transmission` or `reflection`", "materials", name, "fresnel")
    if material.roughness != 0 and not material.is_specular:
        what = f"`roughness` of `{name}` changes nothing, as it neither reflects nor transmits"
        findings.warning(what, "add `transmission` or `reflection`", "materials", name, "roughness")
    if material.dispersion not in (None, 0) and not material.is_transmissive:
        what = f"`dispersion` of `{name}` changes nothing, as it does not transmit"
        findings.warning(what, "add `transmission` or remove it", "materials", name, "dispersion")


def _lowest_index(material: Material, paper: Paper) -> float | None:
    """The smallest refraction index over the visible bands, None without ior or dispersion."""
    if material.ior is None or material.dispersion is None:
        return None
    if isinstance(material.dispersion, Abbe):
        return min(abbe_index(material.ior, material.dispersion.abbe, nm) for nm in (_SHORTEST_NM, _LONGEST_NM))
    # Follow the paper's bands R, Y, G, B, counted from the band that `ior` belongs to.
    step, start = index_step(material.dispersion, paper), ior_position(paper)
    return min(material.ior + step * (band - start) for band in range(4))
