"""What the noise of an observation comes from, side by side, as ``results.json`` has it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import assert_never

from pydantic import Field

from vitrail.base.record import Record
from vitrail.images.patch import PatchSamples
from vitrail.metrics.noise_causes import noise_causes
from vitrail.scene.model import Area, Directional, Emitter, Environment, Point, Scene, Spot


class NoiseRecord(Record):
    """Mean variance of a cell of the patch by cause, (W sr^-1 m^-2)^2, in one side's picture."""

    side: str
    photons: float = Field(ge=0)
    edges: float = Field(ge=0)
    rays: float = Field(ge=0)


def noise_records(samples: Mapping[str, PatchSamples], scene: Scene) -> tuple[NoiseRecord, ...]:
    """The causes of each side's noise; the layers that tell them apart are those of the side that has some."""
    draws_rays = _draws_rays(scene)
    layers = next((each.layers for each in samples.values() if each.layers), {})
    return tuple(
        NoiseRecord(side=side, **asdict(noise_causes(each.noise, each.values, layers, draws_rays=draws_rays)))
        for side, each in samples.items()
        if each.noise is not None
    )


def _draws_rays(scene: Scene) -> bool:
    """Whether anything is seen by rays drawn at random: rough faces, lamps with a size, skies, final gathering."""
    rough = any(material.roughness != 0.0 for material in scene.materials.values())
    return rough or scene.transport.indirect == "photons" or any(_has_size(light.emitter) for light in scene.lights)


def _has_size(emitter: Emitter) -> bool:
    match emitter:
        case Directional():
            return emitter.angular_diameter_deg > 0
        case Area():
            return not emitter.collimated
        case Environment():
            return True
        case Point() | Spot():
            return False
        case _:
            assert_never(emitter)
