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
from vitrail.lower.povray.gaps import Placement, with_gaps
from vitrail.lower.povray.light_factor import light_factor
from vitrail.lower.povray.lights import Source, light_sdl, sources
from vitrail.lower.povray.modes import Mode, mode_of
from vitrail.lower.povray.normalise import Normalisation, normalise
from vitrail.lower.povray.objects import ObjectText
from vitrail.lower.povray.photons import PhotonPass, photon_pass
from vitrail.lower.povray.refusal import Refusals
from vitrail.lower.povray.residuals import ADC_BAILOUT, Translation, certificate_of
from vitrail.lower.povray.sdl import block, number, rgb
from vitrail.lower.povray.support import refuse_unsupported
from vitrail.plan.budget import Settings
from vitrail.plan.plan import Plan
from vitrail.scene.load import Loaded
from vitrail.scene.model import Ambient, Scene
from vitrail.scene.print import scene_hash


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

    @property
    def texts(self) -> dict[str, str]:
        """File name to scene text, in the order in which they run."""
        shoot = {} if self.photon_sdl is None else {f"{self.name}.photons.pov": self.photon_sdl}
        return {**shoot, f"{self.name}.pov": self.sdl}


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
    placement: Placement
    objects: ObjectText


def lower_povray(scene: Scene, plan: Plan, settings: Settings, loaded: Loaded | None = None) -> PovrayScene:
    """The runs and the certificate. Raises NotTranslatable with the scene's lines (taken from ``loaded``)."""
    refusals = Refusals(loaded)
    refuse_unsupported(scene, plan, settings, refusals)
    units = normalise(scene, refusals)
    lights = sources(scene, units, refusals)
    photons = photon_pass(scene, plan, settings, lights, units, refusals)
    depth, placement = trace_depth(plan), with_gaps(scene, units)
    objects = ObjectText(scene, plan, units, has_photons=photons is not None)
    parts = _Parts(scene, plan, units, lights, photons, depth, placement, objects)
    mode = mode_of(scene, settings, photons)
    return PovrayScene(
        title=scene.title,
        scene_hash=scene_hash(scene),
        width=scene.image.width,
        height=scene.image.height,
        runs=tuple(_runs(parts, mode, settings)),
        certificate=certificate_of(Translation(scene, plan, mode, units, lights, photons, depth, placement.shrunk)),
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
        for shown in mode.exposures:
            factor = light_factor(parts.scene, parts.lights, parts.photons, shown)
            exposure = replace(shown, light_factor=factor)
            shoots = parts.photons is not None and has_light(parts.lights, exposure)
            name = half + _suffix(exposure)
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


def _suffix(exposure: Exposure) -> str:
    """The channels that a run stands for, in its name; nothing where it shows them all in colour."""
    if exposure.channel is None:
        return ""
    return "_" + "_".join(("red", "green", "blue")[index] for index in exposure.stands_for)


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
    placed = parts.placement.placed
    lines += [parts.objects.sdl(item, shape, exposure) for item, shape in zip(scene.objects, placed, strict=True)]
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
