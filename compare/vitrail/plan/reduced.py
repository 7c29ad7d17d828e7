"""A scene without what its plan leaves out: what both back ends translate."""

from __future__ import annotations

from typing import Any

from vitrail.base.changed import changed, unchecked
from vitrail.base.phenomenon import Phenomenon
from vitrail.optics.dispersion import reference_ior
from vitrail.plan.evidence.surfaces import is_weak_mirror
from vitrail.plan.plan import Plan
from vitrail.scene.model import Material, Scene


def reduced(scene: Scene, plan: Plan) -> Scene:
    """The scene with smooth faces where the plan needs no roughness, one index where it needs no dispersion, clear
    glass where it needs no absorption, and no mirror where it needs no reflection. Objects and lights stay.
    """
    materials = {name: _reduced(material, plan) for name, material in scene.materials.items()}
    indirect = scene.transport.indirect if plan.requires(Phenomenon.INDIRECT_LIGHT) else "none"
    transport = changed(
        scene.transport,
        indirect=indirect,
        max_reflections=plan.chain.reflections,
        max_transmissions=plan.chain.transmissions,
    )
    return unchecked(scene, materials=materials, transport=transport)


def _reduced(material: Material, plan: Plan) -> Material:
    update: dict[str, Any] = {}
    if not plan.requires(Phenomenon.ROUGHNESS):
        update["roughness"] = 0.0
    if not plan.requires(Phenomenon.DISPERSION) and material.is_dispersive:
        update |= {"dispersion": None, "glass": None, "ior": reference_ior(material)}
    if not plan.requires(Phenomenon.ABSORPTION):
        update |= {"attenuation": None, "absorption_per_m": None}
    if not plan.requires(Phenomenon.REFLECTION) and is_weak_mirror(material):
        update["reflection"] = (0.0, 0.0, 0.0)
    # What is taken away breaks no rule of a material, and one that was spoilt on purpose goes on to the engines.
    return unchecked(material, **update)
