"""Reference modes: everything in one run, one run a channel where photons would lose colour, or one run a band."""

from __future__ import annotations

from dataclasses import dataclass, replace

from vitrail.base.colour import Triplet
from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.sky import Skies, Sky
from vitrail.optics.bands import ALL_LIGHT, Band, band_model, spectral
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Settings
from vitrail.scene.colours import colours_of
from vitrail.scene.model import Light, Scene

ALL = (Exposure(),)
SAME_CHANNELS = 1e-12
"""Channels closer than this, relative, have the same photons."""
MOST_SLICES = 16
"""Bands up to which there is one run a band; of more, so many wider ones stand for all."""


@dataclass(frozen=True)
class Mode:
    """``name`` is native, channels or slices; ``exposures`` are the runs of one half; ``reason`` is for the reader.

    ``bands`` is one band of all light where the plan has no dispersion.
    """

    name: str
    exposures: tuple[Exposure, ...]
    bands: tuple[Band, ...]
    reason: str

    @property
    def shows_all_channels(self) -> bool:
        """Whether one run shows all three channels, in colour."""
        return any(exposure.channel is None for exposure in self.exposures)

    @property
    def is_sliced(self) -> bool:
        return any(exposure.band is not None for exposure in self.exposures)


def mode_of(scene: Scene, plan: Plan, settings: Settings, skies: Skies) -> Mode:
    """The asked mode; ``auto`` takes channels wherever one photon colour or one pool s cannot serve all three.

    With dispersion ``auto`` and ``channels`` mean one run a band. POV-Ray's own dispersion is no substitute where there
    are very many: it keeps red light for ever inside a ball where Fresnel at its one index mirrors all of it, and its
    colours are others.
    """
    bands = band_model(scene.transport.bands).bands if plan.requires(Phenomenon.DISPERSION) else (ALL_LIGHT,)
    if settings.reference_mode == "native":
        return Mode("native", ALL, bands, "asked for")
    exposures, reason = _by_channel(scene, plan, settings, skies)
    if len(bands) == 1:
        return Mode("native" if exposures == ALL else "channels", exposures, bands, reason)
    if len(bands) <= MOST_SLICES or settings.reference_mode == "slices":
        return Mode("slices", _sliced(exposures, bands), bands, f"one run a band has no error of the index; {reason}")
    wide = spectral(MOST_SLICES).bands
    why = f"{len(bands)} bands are too many for a run each, so that {len(wide)} stand for them; {reason}"
    return Mode("slices", _sliced(exposures, wide), wide, why)


def _by_channel(scene: Scene, plan: Plan, settings: Settings, skies: Skies) -> tuple[tuple[Exposure, ...], str]:
    """The exposures that the channels need, and why."""
    if settings.reference_mode == "channels":
        return _apart(scene, skies), "asked for"
    if coloured := _coloured_glass(scene):
        return _apart(scene, skies), f"material {coloured} treats the channels of light differently"
    if plan.requires(Phenomenon.CAUSTIC) and (lamp := _coloured_light(scene, skies)):
        return _apart(scene, skies), f"light {lamp} has channels that photons would round differently"
    return ALL, "every channel of light is treated alike"


def _sliced(exposures: tuple[Exposure, ...], bands: tuple[Band, ...]) -> tuple[Exposure, ...]:
    """Each exposure in each band, where the band has a share in it at all."""
    return tuple(
        replace(exposure, band=index, weight=band.weight)
        for index, band in enumerate(bands)
        for exposure in exposures
        if any(band.weight[channel] != 0 for channel in exposure.stands_for)
    )


def _apart(scene: Scene, skies: Skies) -> tuple[Exposure, ...]:
    """One exposure for each group of channels that the whole scene treats alike."""
    colours = [*colours_of(scene), *(colour for sky in skies.values() for colour in sky.colours)]
    groups: list[list[int]] = []
    for channel in range(3):
        alike = next((g for g in groups if all(colour[g[0]] == colour[channel] for colour in colours)), None)
        if alike is None:
            groups.append([channel])
        else:
            alike.append(channel)
    return tuple(Exposure(group[0], stands_for=tuple(group)) for group in groups)


def _coloured_glass(scene: Scene) -> str:
    """The first specular material whose faces or inside are coloured; empty where there is none."""
    for name, material in scene.materials.items():
        inside = material.absorption_per_m or (material.attenuation.color if material.attenuation else (0.0,) * 3)
        colours: tuple[Triplet, ...] = (material.reflection, material.transmission, inside)
        if material.is_specular and any(_is_coloured(colour) for colour in colours):
            return f"`{name}`"
    return ""


def light_colours(light: Light, sky: Sky | None) -> list[Triplet]:
    """What a light sends, the most coloured pixels of a sky that is an image."""
    if sky is not None:
        return list(sky.colours)
    emitter = light.emitter
    return [value for key in ("irradiance", "intensity", "radiance") if (value := getattr(emitter, key, None))]


def _coloured_light(scene: Scene, skies: Skies) -> str:
    for index, light in enumerate(scene.lights):
        if any(_is_coloured(colour) for colour in light_colours(light, skies.get(index))):
            return f"`{light.name}`"
    return ""


def _is_coloured(colour: Triplet) -> bool:
    return max(colour) - min(colour) > SAME_CHANNELS * max(colour)
