"""What the materials and the transport of a scene allow, wherever its objects are: the plan that leaves nothing out."""

from __future__ import annotations

from typing import assert_never

from vitrail.base.phenomenon import Phenomenon
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.model import Scene


def could_occur(phenomenon: Phenomenon, scene: Scene) -> bool:
    """Whether some placement of the same objects could show a phenomenon."""
    materials = [scene.material_of(item) for item in scene.objects]
    glass = [material for material in materials if material.is_transmissive]
    match phenomenon:
        case Phenomenon.DIFFUSION | Phenomenon.SHADOW:
            return True
        case Phenomenon.REFLECTION | Phenomenon.CAUSTIC:
            return any(material.is_specular for material in materials)
        case Phenomenon.REFRACTION | Phenomenon.TOTAL_INTERNAL_REFLECTION | Phenomenon.COLOURED_TRANSMISSION:
            return bool(glass)
        case Phenomenon.ABSORPTION:
            return any(max(absorption_per_m(material)) > 0 for material in glass)
        case Phenomenon.ROUGHNESS:
            return any(material.is_specular and material.roughness != 0 for material in materials)
        case Phenomenon.DISPERSION:
            return any(material.is_dispersive for material in glass)
        case Phenomenon.INDIRECT_LIGHT:
            return scene.transport.indirect != "none"
        case _:
            assert_never(phenomenon)
