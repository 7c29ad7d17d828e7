"""Reference modes: all three channels in one run, or one run a channel where POV-Ray's photons would lose colour."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from vitrail.lower.povray.exposure import Exposure, Triplet
from vitrail.lower.povray.photons import PhotonPass
from vitrail.plan.budget import Settings
from vitrail.scene.model import Scene

ALL = (Exposure(),)
SAME_CHANNELS = 1e-12
"""Channels closer than this, relative, have the same photons."""


@dataclass(frozen=True)
class Mode:
    """``name`` is native, channels or slices; ``exposures`` are the runs of one half; ``reason`` is for the reader."""

    name: str
    exposures: tuple[Exposure, ...]
    reason: str

    @property
    def shows_all_channels(self) -> bool:
        """Whether one run shows all three channels, in colour."""
        return any(exposure.channel is None for exposure in self.exposures)


def mode_of(scene: Scene, settings: Settings, photons: PhotonPass | None) -> Mode:
    """The asked mode; ``auto`` takes channels wherever one photon colour or one pool s cannot serve all three."""
    coloured = _coloured_glass(scene)
    if settings.reference_mode == "native":
        return Mode("native", ALL, "asked for")
    if settings.reference_mode == "channels":
        return Mode("channels", _apart(scene), "asked for")
    if coloured:
        return Mode("channels", _apart(scene), f"material {coloured} treats the channels of light differently")
    if photons is not None and (lamp := _coloured_light(scene)):
        return Mode("channels", _apart(scene), f"light {lamp} has channels that photons would round differently")
    return Mode("native", ALL, "every channel of light is treated alike")


def _apart(scene: Scene) -> tuple[Exposure, ...]:
    """One exposure for each group of channels that the whole scene treats alike."""
    colours = list(_colours(scene.model_dump()))
    groups: list[list[int]] = []
    for channel in range(3):
        alike = next((g for g in groups if all(colour[g[0]] == colour[channel] for colour in colours)), None)
        if alike is None:
            groups.append([channel])
        else:
            alike.append(channel)
    return tuple(Exposure(group[0], stands_for=tuple(group)) for group in groups)


COLOUR_KEYS = {
    "diffuse",
    "reflection",
    "transmission",
    "emission",
    "absorption_per_m",
    "color",
    "colors",
    "irradiance",
    "intensity",
    "radiance",
    "ambient",
}
"""Every key of the scene language that holds colours."""


def _colours(part: object, key: str = "") -> Iterator[Triplet]:
    """All colours of a dumped scene."""
    match part:
        case dict():
            for name, value in part.items():
                yield from _colours(value, name)
        case tuple() | list() if key in COLOUR_KEYS and len(part) == 3 and isinstance(part[0], float | int):
            yield (part[0], part[1], part[2])
        case tuple() | list():
            for value in part:
                yield from _colours(value, key)
        case _:
            return


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
