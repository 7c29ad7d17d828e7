"""The one vocabulary of phenomena: planned, rendered, measured, judged and reported under these names."""

from __future__ import annotations

from enum import StrEnum


class Phenomenon(StrEnum):
    """What glass does to light, one name each, the same in scene, C++, JSON and report."""

    DIFFUSION = "diffusion"
    REFLECTION = "reflection"
    REFRACTION = "refraction"
    TOTAL_INTERNAL_REFLECTION = "total_internal_reflection"
    COLOURED_TRANSMISSION = "coloured_transmission"
    ABSORPTION = "absorption"
    CAUSTIC = "caustic"
    ROUGHNESS = "roughness"
    DISPERSION = "dispersion"
    SHADOW = "shadow"
    INDIRECT_LIGHT = "indirect_light"
