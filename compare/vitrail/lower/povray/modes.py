"""Reference modes: all three channels in one run, or one run a channel where POV-Ray's photons would lose colour."""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.lower.povray.exposure import Triplet
from vitrail.lower.povray.photons import PhotonPass
from vitrail.plan.budget import Settings
from vitrail.scene.model import Scene

SAME_CHANNELS = 1e-12
"""Channels closer than this, relative, have the same photons."""


@dataclass(frozen=True)
class Mode:
    """``name`` is native, channels or slices; ``channels`` are the runs of one half; ``reason`` is for the reader."""

    name: str
    channels: tuple[int | None, ...]
    reason: str


def mode_of(scene: Scene, settings: Settings, photons: PhotonPass | None) -> Mode:
    """The asked mode; ``auto`` takes channels wherever one photon colour or one pool s cannot serve all three."""
    coloured = _coloured_glass(scene)
    if settings.reference_mode == "native":
        return Mode("native", (None,), "asked for")
    if settings.reference_mode == "channels":
        return Mode("channels", (0, 1, 2), "asked for")
    if coloured:
        return Mode("channels", (0, 1, 2), f"material {coloured} treats the channels of light differently")
    if photons is not None and (lamp := _coloured_light(scene)):
        return Mode("channels", (0, 1, 2), f"light {lamp} has channels that photons would round differently")
    return Mode("native", (None,), "every channel of light is treated alike")


def _coloured_glass(scene: Scene) -> str:
    """Number of the first specular material whose faces or inside are coloured (M1 is the first material)."""
    for index, material in enumerate(scene.materials.values(), 1):
        inside = material.absorption_per_m or (material.attenuation.color if material.attenuation else (0.0,) * 3)
        colours: tuple[Triplet, ...] = (material.reflection, material.transmission, inside)
        if material.is_specular and any(_is_coloured(colour) for colour in colours):
            return f"M{index}"
    return ""


def _coloured_light(scene: Scene) -> str:
    for index, light in enumerate(scene.lights, 1):
        emitter = light.emitter
        colour = next(
            (value for key in ("irradiance", "intensity", "radiance") if (value := getattr(emitter, key, None))), None
        )
        if colour is not None and _is_coloured(colour):
            return f"L{index}"
    return ""


def _is_coloured(colour: Triplet) -> bool:
    return max(colour) - min(colour) > SAME_CHANNELS * max(colour)
