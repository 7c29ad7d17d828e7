"""Back end for POV-Ray: the scene as a set of runs whose weighted images add up to the radiance, and a certificate.

Two half images estimate the noise: they differ in the pattern of photons and of the small lights that stand for a lamp.
Each half is one run, or one a channel where POV-Ray's photons would lose colour, or one a band of light.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.contact import with_contacts
from vitrail.lower.povray.bodies.gaps import with_gaps
from vitrail.lower.povray.bodies.meshes import refuse_unreadable_meshes
from vitrail.lower.povray.bodies.nesting import nesting_of
from vitrail.lower.povray.bodies.normalise import Normalisation, normalise
from vitrail.lower.povray.certificate.certificate import Certificate
from vitrail.lower.povray.certificate.residuals import Translation, certificate_of
from vitrail.lower.povray.photons.depth import trace_depth
from vitrail.lower.povray.photons.light_factor import light_factor
from vitrail.lower.povray.photons.off_centre import off_centre
from vitrail.lower.povray.photons.photons import PhotonPass, photon_pass, photon_targets
from vitrail.lower.povray.refusals.refusal import Refusals
from vitrail.lower.povray.refusals.support import refuse_unsupported
from vitrail.lower.povray.text.camera import HALF_SHIFTS
from vitrail.lower.povray.text.emitters import Grid
from vitrail.lower.povray.text.exposure import Triplet
from vitrail.lower.povray.text.indices import Indices
from vitrail.lower.povray.text.lights import sources
from vitrail.lower.povray.text.modes import Mode, mode_of
from vitrail.lower.povray.text.objects import ObjectText
from vitrail.lower.povray.text.printer import printed
from vitrail.lower.povray.text.scene_text import SceneText
from vitrail.lower.povray.text.sdl import SdlFile
from vitrail.lower.povray.text.sky import SkyPicture, skies_of
from vitrail.plan.plan import Plan
from vitrail.plan.reduced import reduced
from vitrail.plan.settings import Quality, Settings
from vitrail.scene.print import scene_hash

EMITTERS: dict[Quality, int] = {Quality.DRAFT: 12, Quality.NORMAL: 24, Quality.REFERENCE: 96}
"""Small lights that stand for one with a surface or a solid angle, in each half image."""


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
    refusals, identity = Refusals(world.loaded), scene_hash(world.scene)
    world = world.with_scene(reduced(world.scene, plan))
    refuse_unsupported(world, plan, refusals)
    refuse_unreadable_meshes(world, refusals)
    skies = skies_of(world.scene, world.folder or Path(), refusals)
    radius = settings.gather_radius_m if plan.requires(Phenomenon.CAUSTIC) else 0.0
    units = normalise(world, refusals, radius)
    joined = with_contacts(world, units)
    world, scene = joined.world, joined.world.scene
    mode = mode_of(scene, plan, settings, skies)
    indices = Indices(scene, mode.bands, mode.is_sliced)
    grid = Grid(EMITTERS[settings.quality], settings.seed)
    targets = photon_targets(world, plan, units, refusals)
    lights = {
        half: off_centre(sources(world, units, replace(grid, is_mirrored=other), skies, refusals), targets, other)
        for half, other in (("a", False), ("b", True))
    }
    photons = photon_pass(plan, settings, lights["a"], len(mode.bands), targets, units, refusals)
    depth, placement = trace_depth(plan, settings.quality), with_gaps(world, units, joined.contacts)
    nesting = nesting_of(world, units, joined.pairs)
    objects = ObjectText(world, plan, units, photons is not None, indices, nesting, joined.under)
    text = SceneText(world, plan, units, lights, skies, photons, depth, placement, objects, settings.quality)
    translation = Translation(
        world=world,
        plan=plan,
        mode=mode,
        units=units,
        lights=lights["a"],
        skies=skies,
        photons=photons,
        depth=depth,
        shrunk=placement.shrunk,
        grown=joined.grown,
        indices=indices,
        nesting=nesting,
        quality=settings.quality,
    )
    return PovrayScene(
        title=scene.title,
        scene_hash=identity,
        width=scene.image.width,
        height=scene.image.height,
        runs=tuple(_runs(text, mode, settings)),
        certificate=certificate_of(translation),
        normalisation=units,
        settings=settings,
        mode=mode,
        photons=photons,
    )


def _runs(text: SceneText, mode: Mode, settings: Settings) -> Iterator[PovrayRun]:
    """One run a half and exposure."""
    across = math.ceil(math.sqrt(settings.samples))
    image = text.scene.image
    for half in HALF_SHIFTS:
        for shown in mode.exposures:
            plain = replace(shown, half=half)
            factor = light_factor(text.scene, text.lights[half], text.skies, text.photons, plain)
            exposure = replace(plain, light_factor=factor)
            shoots = text.photons is not None and text.has_light(half, exposure)
            sky = text.sky_picture(exposure)
            yield PovrayRun(
                name="_".join(part for part in (half, exposure.name) if part),
                half=half,
                scene=text.sdl(half, exposure, across, "load_file" if shoots else "", sky),
                photon_scene=text.sdl(half, exposure, across, "save_file", sky) if shoots else None,
                width=image.width * across,
                height=image.height * across,
                samples_across=across,
                gain=exposure.gain,
                max_trace_level=text.depth.level,
                depth_is_proven=text.depth.is_proven,
                sky=sky,
            )
