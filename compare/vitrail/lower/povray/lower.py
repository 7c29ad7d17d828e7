"""Back end for POV-Ray: the scene as a set of runs whose weighted images add up to the radiance, and a certificate.

Two half images estimate the noise: they differ in the pattern of photons and of the small lights that stand for a lamp.
Each half is one run, or one a channel where POV-Ray's photons would lose colour, or one a band of light.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

from vitrail.base.colour import Triplet
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.certificate.certificate import Certificate
from vitrail.lower.povray.certificate.residuals import certificate_of
from vitrail.lower.povray.photons.light_factor import light_factor
from vitrail.lower.povray.photons.photons import PhotonPass
from vitrail.lower.povray.text.camera import HALF_SHIFTS
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.modes import Mode
from vitrail.lower.povray.text.printer import printed
from vitrail.lower.povray.text.scene_text import SceneText
from vitrail.lower.povray.text.sdl import SdlFile
from vitrail.lower.povray.text.sky import SkyPicture
from vitrail.lower.povray.translation import Translation, translate
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Settings
from vitrail.scene.print import scene_hash


@dataclass(frozen=True)
class PovrayRun:
    """One execution of POV-Ray: scene text, image size, and how its image counts.

    The radiance of a half image is the sum over its runs of ``gain`` times the image, averaged over blocks of
    ``samples_across`` x ``samples_across`` pixels. Where there are photons, ``photon_scene`` shoots and saves them, and
    ``scene`` loads them. Both look for the file of ``sky``, if there is one, beside them.
    """

    name: str
    half: str
    scene: SdlFile
    photon_scene: SdlFile | None
    width: int
    height: int
    samples_across: int
    gain: Triplet
    max_trace_level: int
    depth_is_proven: bool
    sky: SkyPicture | None = None

    @cached_property
    def sdl(self) -> str:
        """The text that draws."""
        return printed(self.scene)

    @cached_property
    def photon_sdl(self) -> str | None:
        """The text that shoots photons, if there are any."""
        return None if self.photon_scene is None else printed(self.photon_scene)

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


def lower_povray(world: World, plan: Plan, settings: Settings) -> PovrayScene:
    """The runs and the certificate. Raises NotTranslatable with the lines of the scene's file."""
    translation = translate(world, plan, settings)
    image = translation.scene.image
    return PovrayScene(
        title=translation.scene.title,
        scene_hash=scene_hash(world.scene),
        width=image.width,
        height=image.height,
        runs=tuple(_runs(translation)),
        certificate=certificate_of(translation),
        normalisation=translation.units,
        settings=settings,
        mode=translation.mode,
        photons=translation.photons,
    )


def _runs(translation: Translation) -> Iterator[PovrayRun]:
    """One run for each half image and exposure."""
    text = SceneText(translation)
    for half in HALF_SHIFTS:
        for shown in translation.mode.exposures:
            plain = replace(shown, half=half)
            yield _run(text, replace(plain, light_factor=light_factor(translation, plain)))


def _run(text: SceneText, exposure: Exposure) -> PovrayRun:
    translation, half = text.translation, exposure.half
    across, depth = math.ceil(math.sqrt(translation.settings.samples)), translation.depth
    shoots = translation.photons is not None and text.has_light(exposure)
    sky = text.sky_picture(exposure)
    return PovrayRun(
        name="_".join(part for part in (half, exposure.name) if part),
        half=half,
        scene=text.sdl(exposure, across, "load_file" if shoots else "", sky),
        photon_scene=text.sdl(exposure, across, "save_file", sky) if shoots else None,
        width=translation.scene.image.width * across,
        height=translation.scene.image.height * across,
        samples_across=across,
        gain=exposure.gain,
        max_trace_level=depth.level,
        depth_is_proven=depth.is_proven,
        sky=sky,
    )
