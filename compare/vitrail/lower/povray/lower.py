"""Back end for POV-Ray: the scene as a set of runs whose weighted images add up to the radiance, and a certificate.

Two half images estimate the noise: they differ in the pattern of photons and in where they sample a pixel. Each half is
one run, or three (one a channel) where POV-Ray's photons would lose colour.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from vitrail.lower.povray.camera import HALF_SHIFTS, camera_sdl
from vitrail.lower.povray.certificate import Certificate
from vitrail.lower.povray.depth import TraceDepth, trace_depth
from vitrail.lower.povray.exposure import Exposure, Triplet
from vitrail.lower.povray.lights import Source, light_sdl, sources
from vitrail.lower.povray.materials import Surface, texture_sdl
from vitrail.lower.povray.modes import Mode, mode_of
from vitrail.lower.povray.normalise import Normalisation, normalise
from vitrail.lower.povray.photons import PhotonPass, light_factor, photon_pass
from vitrail.lower.povray.refusal import Refusals
from vitrail.lower.povray.residuals import certificate_of
from vitrail.lower.povray.sdl import block, number, rgb
from vitrail.lower.povray.shapes import primitive
from vitrail.lower.povray.support import refuse_unsupported
from vitrail.plan.budget import Settings
from vitrail.plan.plan import Plan
from vitrail.scene.print import scene_hash
from vitrail.scene.load import Loaded
from vitrail.scene.model import Ambient, Material, Object, Scene
from vitrail.scene.phenomenon import Phenomenon
from vitrail.scene.placement import place

ADC_BAILOUT = 1e-6
"""Path weight below which POV-Ray gives up; the default of 1/255 turns glass black [P 4.3]."""


@dataclass(frozen=True)
class PovrayRun:
    """One execution of POV-Ray: scene text, image size, and how its image counts.

    The radiance of a half image is the sum over its runs of ``gain`` times the image, averaged over blocks of
    ``samples_across`` x ``samples_across`` pixels. Where there are photons, ``photon_sdl`` shoots and saves them, and
    ``sdl`` loads them.
    """

    name: str
    half: str
    sdl: str
    photon_sdl: str | None
    width: int
    height: int
    samples_across: int
    gain: Triplet
    max_trace_level: int
    depth_is_proven: bool


@dataclass(frozen=True)
class PovrayScene:
    """Everything POV-Ray needs for one scene, and what it will do differently."""

    title: str
    scene_hash: str
    width: int
    height: int
    runs: tuple[PovrayRun, ...]
    certificate: Certificate
    normalisation: Normalisation
    settings: Settings
    mode: Mode
    photons: PhotonPass | None


@dataclass(frozen=True)
class _Parts:
    """What every run of a scene shares."""

    scene: Scene
    plan: Plan
    units: Normalisation
    lights: tuple[Source, ...]
    photons: PhotonPass | None
    depth: TraceDepth


def lower_povray(scene: Scene, plan: Plan, settings: Settings, loaded: Loaded | None = None) -> PovrayScene:
    """The runs and the certificate. Raises NotTranslatable with the scene's lines (taken from ``loaded``)."""
    refusals = Refusals(loaded)
    refuse_unsupported(scene, plan, settings, refusals)
    units = normalise(scene, refusals)
    lights = sources(scene, units, refusals)
    photons = photon_pass(scene, plan, settings, lights, units, refusals)
    parts = _Parts(scene, plan, units, lights, photons, trace_depth(plan))
    mode = mode_of(scene, settings, photons)
    return PovrayScene(
        title=scene.title,
        scene_hash=scene_hash(scene),
        width=scene.image.width,
        height=scene.image.height,
        runs=tuple(_runs(parts, mode, settings)),
        certificate=certificate_of(scene, plan, mode, units, lights, photons, parts.depth),
        normalisation=units,
        settings=settings,
        mode=mode,
        photons=photons,
    )


def _runs(parts: _Parts, mode: Mode, settings: Settings) -> list[PovrayRun]:
    """One run a half and channel."""
    across = math.ceil(math.sqrt(settings.samples / len(HALF_SHIFTS)))
    image = parts.scene.image
    found = []
    for half in HALF_SHIFTS:
        for channel in mode.channels:
            exposure = Exposure(channel)
            factor = light_factor(parts.scene, parts.lights, parts.photons, exposure, parts.units)
            exposure = replace(exposure, light_factor=factor)
            shoots = parts.photons is not None and has_light(parts.lights, exposure)
            name = half if channel is None else f"{half}_{('red', 'green', 'blue')[channel]}"
            found.append(
                PovrayRun(
                    name=name,
                    half=half,
                    sdl=_scene_sdl(parts, half, exposure, across, "load_file" if shoots else ""),
                    photon_sdl=_scene_sdl(parts, half, exposure, across, "save_file") if shoots else None,
                    width=image.width * across,
                    height=image.height * across,
                    samples_across=across,
                    gain=exposure.gain,
                    max_trace_level=parts.depth.level,
                    depth_is_proven=parts.depth.is_proven,
                )
            )
    return found


def has_light(lights: Sequence[Source], exposure: Exposure) -> bool:
    """Whether any light shines in the channel of a run."""
    return any(max(exposure.share(source.strength)) > 0 for source in lights)


def _scene_sdl(parts: _Parts, half: str, exposure: Exposure, samples_across: int, photon_file: str) -> str:
    """The whole scene text of one run; without ``photon_file`` there are no photons in it."""
    scene = parts.scene
    lines = [
        "#version 3.7;",
        _globals(parts, half, exposure, photon_file),
        "#default { finish { ambient 0 emission 0 diffuse 0 } }",
        "background { rgb 0 }",
        camera_sdl(scene.camera, scene.image, samples_across, HALF_SHIFTS[half], parts.units),
    ]
    lines += [light_sdl(source, exposure) for source in parts.lights if max(exposure.share(source.strength)) > 0]
    lines += [_object_sdl(item, parts, exposure) for item in scene.objects]
    return "\n".join(lines) + "\n"


def _globals(parts: _Parts, half: str, exposure: Exposure, photon_file: str) -> str:
    return block(
        "global_settings",
        [
            "assumed_gamma 1",
            f"max_trace_level {parts.depth.level}",
            f"adc_bailout {number(ADC_BAILOUT)}",
            _ambient(parts.scene, exposure),
            parts.photons.sdl(half, photon_file) if parts.photons is not None and photon_file else "",
        ],
    )


def _ambient(scene: Scene, exposure: Exposure) -> str:
    """The constant irradiance of ``indirect: {ambient: c}``; surfaces answer to it with ``ambient 1``."""
    indirect = scene.transport.indirect
    if not isinstance(indirect, Ambient):
        return ""
    red, green, blue = exposure.light(indirect.ambient)
    return f"ambient_light {rgb((red / math.pi, green / math.pi, blue / math.pi))}"


def _object_sdl(item: Object, parts: _Parts, exposure: Exposure) -> str:
    material, placed = parts.scene.material_of(item), place(item)
    shape = primitive(placed, parts.units)
    texture = texture_sdl(Surface(material, placed, exposure, parts.units))
    return block(
        shape.keyword, [*shape.parts, texture, _interior(material, parts, exposure), _targets(material, parts)]
    )


def _interior(material: Material, parts: _Parts, exposure: Exposure) -> str:
    """The index where light enters or Fresnel asks for it, and the absorption where the plan wants it."""
    if not material.is_transmissive and not (material.fresnel and material.is_specular):
        return ""
    assert material.ior is not None
    absorbing = material.is_transmissive and parts.plan.requires(Phenomenon.ABSORPTION)
    fade = _fade(exposure.share(absorption_per_unit(material, parts.units))) if absorbing else ""
    return block("interior", [f"ior {number(material.ior)}", fade])


def absorption_per_unit(material: Material, units: Normalisation) -> Triplet:
    """Beer-Lambert coefficients per unit of length."""
    if material.absorption_per_m is not None:
        found = material.absorption_per_m
    elif material.attenuation is not None:
        red, green, blue = (-math.log(each) / material.attenuation.distance for each in material.attenuation.color)
        found = (red, green, blue)
    else:
        found = (0.0, 0.0, 0.0)
    return (found[0] / units.scale, found[1] / units.scale, found[2] / units.scale)


def _fade(per_unit: Triplet) -> str:
    """exp(-(1 - fade_color) x / fade_distance), which is Beer-Lambert with fade_color = 1 - sigma [P 3.3]."""
    if max(per_unit) == 0:
        return ""
    remaining = (1 - per_unit[0], 1 - per_unit[1], 1 - per_unit[2])
    return f"fade_distance 1 fade_power 1001 fade_color {rgb(remaining)}"


def _targets(material: Material, parts: _Parts) -> str:
    """Photons are aimed at everything specular; only what scatters collects them."""
    if parts.photons is None or not material.is_specular:
        return ""
    refraction = "on" if material.is_transmissive else "off"
    reflection = "on" if max(material.reflection) > 0 or material.fresnel else "off"
    collect = "" if material.is_diffuse else "collect off"
    return block("photons", ["target", f"refraction {refraction}", f"reflection {reflection}", collect])
