"""What the noise of an observation comes from, side by side, as ``results.json`` has it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict
from typing import assert_never

import numpy as np
from pydantic import Field

from vitrail.base.changed import changed
from vitrail.base.record import Record
from vitrail.images.patch import PatchSamples
from vitrail.metrics.noise_causes import NoiseCauses, noise_causes
from vitrail.scene.model import Area, Directional, Emitter, Environment, Point, Scene, Spot

APART = 1.5
"""How many times more of one kind than of the other must have been bought, before their effects are told apart."""

PHOTON_LAYER = "caustic"
"""The layer whose light photons brought."""

DIRECT_LAYER = "diffusion"
"""The layer of light that no glass and no mirror turned between the lamp and the eye."""


class NoiseRecord(Record):
    """Mean variance of a cell of the patch by cause, (W sr^-1 m^-2)^2, in one side's picture.

    That of photons is already as many times larger as cells share one gather disc.
    """

    side: str
    photons: float = Field(ge=0)
    edges: float = Field(ge=0)
    rays: float = Field(ge=0)


def learnt(before: NoiseRecord, after: NoiseRecord, photons: float, samples: float) -> NoiseRecord:
    """The causes of the noise ``after`` a look with times as many photons and samples, as that look has shown them.

    Photons would leave P / photons, samples the rest over theirs; what is left of both together says how much P was,
    wherever in the picture it lies. Without noise, or where both grew nearly alike, nothing is learnt.
    """
    whole, left = (each.photons + each.edges + each.rays for each in (before, after))
    ratio = photons / samples
    if not (whole > 0 and left > 0) or 1 / APART < ratio < APART:
        return after
    shown = min(max((whole - samples * left) / (photons - samples), 0.0), left)
    rest = after.edges + after.rays
    edges = after.edges / rest if rest > 0 else 1.0
    return changed(after, photons=shown, edges=(left - shown) * edges, rays=(left - shown) * (1 - edges))


def noise_records(
    samples: Mapping[str, PatchSamples], scene: Scene, gather_radius_m: float = 0.0
) -> tuple[NoiseRecord, ...]:
    """The causes of each side's noise; the layers that tell them apart are those of the side that has some."""
    layers = next((each.layers for each in samples.values() if each.layers), {})
    return tuple(
        NoiseRecord(side=side, **asdict(_causes(each, each.noise, layers, scene, gather_radius_m)))
        for side, each in samples.items()
        if each.noise is not None
    )


def _causes(
    samples: PatchSamples, noise: np.ndarray, layers: Mapping[str, np.ndarray], scene: Scene, gather_radius_m: float
) -> NoiseCauses:
    photons = layers.get(PHOTON_LAYER, np.zeros_like(samples.values))
    drawn = _drawn_light(samples.values, layers, scene)
    disc_cells = math.pi * gather_radius_m**2 / samples.cell_area_m2
    return noise_causes(noise, samples.values, photons, drawn, disc_cells=disc_cells)


def _drawn_light(light: np.ndarray, layers: Mapping[str, np.ndarray], scene: Scene) -> np.ndarray:
    """The light that is seen by rays drawn at random.

    A lamp with a size, a sky or final gathering draws rays everywhere, rough glass where it is looked at. Layers are
    taken as they are: what another engine's light differs by from them is noise, and no light.
    """
    everywhere = _draws_everywhere(scene)
    if not (everywhere or _has_roughness(scene)):
        return np.zeros_like(light)
    if not layers:
        return light
    without = (PHOTON_LAYER,) if everywhere else (PHOTON_LAYER, DIRECT_LAYER)
    found: np.ndarray = sum((layer for name, layer in layers.items() if name not in without), np.zeros_like(light))
    return found


def _has_roughness(scene: Scene) -> bool:
    return any(material.roughness != 0.0 for material in scene.materials.values())


def _draws_everywhere(scene: Scene) -> bool:
    return scene.transport.indirect == "photons" or any(_has_size(light.emitter) for light in scene.lights)


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
