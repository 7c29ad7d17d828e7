"""Lights as the tracer reads them, one kind each."""

from __future__ import annotations

from pathlib import Path
from typing import Any, assert_never

from vitrail.base.packed_numbers import pack
from vitrail.base.vector import unit
from vitrail.lower.tracer.shapes import flat_shape
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
                return {"image": _sky(emitter.file, folder)}
            return {"radiance": emitter.radiance}
        case _:
            assert_never(emitter)


def _area(lamp: Area) -> Json:
    if lamp.collimated:
        return {"shape": flat_shape(lamp.shape), "collimated": True, "irradiance": lamp.strength}
    return {"shape": flat_shape(lamp.shape), "radiance": lamp.strength}


def _sky(file: str, folder: Path | None) -> Json:
    """The pixels of a sky in rows from the top. It is read here and nowhere else."""
    # Images take long to import, and few scenes have one.
    from vitrail.images.sky import read_sky

    radiance = read_sky((folder or Path()) / file)
    height, width, _ = radiance.shape
    return {"width": width, "height": height, "radiance": pack(radiance, "f4")}
