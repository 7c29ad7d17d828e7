"""Lights as the tracer reads them, one kind each."""

from __future__ import annotations

from pathlib import Path
from typing import Any, assert_never

from vitrail.base.vector import unit
from vitrail.lower.tracer.shapes import beside, flat_shape
from vitrail.scene.model import Area, Directional, Environment, Light, Point, Spot

Json = dict[str, Any]


def lowered_light(light: Light, folder: Path | None) -> Json:
    """One light; directions come out with unit length."""
    return {"name": light.name, "kind": light.emitter.key, **_emitter(light, folder)}


def _emitter(light: Light, folder: Path | None) -> Json:
    emitter = light.emitter
    match emitter:
        case Directional():
            return {
                "direction": unit(emitter.direction),
                "irradiance": emitter.irradiance,
                "angular_diameter_deg": emitter.angular_diameter_deg,
            }
        case Point():
            return {"position": emitter.position, "intensity": emitter.intensity}
        case Spot():
            return {
                "position": emitter.position,
                "direction": unit(emitter.direction),
                "intensity": emitter.intensity,
                "cone_deg": emitter.cone_deg,
            }
        case Area():
            return _area(emitter)
        case Environment():
            if emitter.file is not None:
                return {"file": beside(emitter.file, folder)}
            return {"radiance": emitter.radiance}
        case _:
            assert_never(emitter)


def _area(lamp: Area) -> Json:
    if lamp.collimated:
        return {"shape": flat_shape(lamp.shape), "collimated": True, "irradiance": lamp.strength}
    return {"shape": flat_shape(lamp.shape), "radiance": lamp.strength}
