"""Back end for POV-Ray: the scene as a set of runs whose weighted images add up to the radiance, and a certificate.

Two half images estimate the noise: they differ in the pattern of photons and of the small lights that stand for a lamp,
and in where they sample a pixel.
Each half is one run, or one a channel where POV-Ray's photons would lose colour, or one a band of light. A run shoots
its photons once and draws several pictures with them: the scene's own, then one for each view of an observation.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from vitrail.base.colour import Triplet
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.certificate.certificate import Certificate
from vitrail.lower.povray.certificate.residuals import certificate_of
from vitrail.lower.povray.photons.light_factor import light_factor
from vitrail.lower.povray.photons.photons import PhotonPass
from vitrail.lower.povray.sample_grid import half_grids
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.modes import Mode
from vitrail.lower.povray.text.printer import printed
from vitrail.lower.povray.text.scene_text import SceneText
from vitrail.lower.povray.text.sdl import SdlFile
from vitrail.lower.povray.text.sky import SkyPicture
from vitrail.lower.povray.translation import Translation, translate
from vitrail.lower.povray.viewed import refuse_distant_views, seen_by
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Settings
from vitrail.plan.views import ObservationView
from vitrail.scene.print import scene_hash


@dataclass(frozen=True)
class PovrayPicture:
    """One picture of a run: the scene's own, whose ``view`` is empty, or that of a view of an observation.

    A pixel is the mean of a block of ``samples_across`` x ``samples_down`` pixels of what POV-Ray draws.
    """

    view: str
    scene: SdlFile
    width: int
    height: int
    samples_across: int
    samples_down: int

    @cached_property
    def text(self) -> str:
        """The text that draws it."""
        return printed(self.scene)


@dataclass(frozen=True)
class PovrayRun:
    """Executions of POV-Ray that share photons, and how their pictures count.

    The radiance of a half image is the sum over its runs of ``gain`` times the picture. Where there are photons,
    ``photon_scene`` shoots and saves them once, and every picture loads them. All look for the file of ``sky``, if
    there is one, beside them. Branches of a path lighter than ``adc_bailout`` are cut.
    """

    name: str
    half: str
    pictures: tuple[PovrayPicture, ...]
    photon_scene: SdlFile | None
    gain: Triplet
    max_trace_level: int
    adc_bailout: float
    depth_is_proven: bool
    sky: SkyPicture | None = None

    @property
    def sdl(self) -> str:
        """The text that draws the scene's own picture."""
        return self.pictures[0].text

    @cached_property
    def photon_sdl(self) -> str | None:
        """The text that shoots photons, if there are any."""
        return None if self.photon_scene is None else printed(self.photon_scene)

    @property
    def texts(self) -> dict[str, str]:
        """File name to scene text, in the order in which they run."""
        shoot = {} if self.photon_sdl is None else {f"{self.name}.photons.pov": self.photon_sdl}
        # No view can be taken for the photons: its name has no dot.
        names = [f"{self.name}.view.{each.view}.pov" if each.view else f"{self.name}.pov" for each in self.pictures]
        return {**shoot, **{name: each.text for name, each in zip(names, self.pictures, strict=True)}}


@dataclass(frozen=True)
class PovrayScene:
    """Everything POV-Ray needs for one scene, and what it will do differently.

    Branches below ``adc_bailout`` of a look are dropped.
    """

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
    adc_bailout: float
    views: tuple[ObservationView, ...] = ()


def lower_povray(world: World, plan: Plan, settings: Settings, views: Sequence[ObservationView] = ()) -> PovrayScene:
    """The runs and the certificate. Raises NotTranslatable with the lines of the scene's file.

    Units, gaps, depth and photons come from the scene alone; a view adds a camera, a size and its own samples.
    """
    translation = translate(world, plan, settings)
    refuse_distant_views(world, translation.units, views)
    image = translation.scene.image
    return PovrayScene(
        title=translation.scene.title,
        scene_hash=scene_hash(world.scene),
        width=image.width,
        height=image.height,
        runs=tuple(_runs(translation, views)),
        certificate=certificate_of(translation),
        normalisation=translation.units,
        settings=settings,
        mode=translation.mode,
        photons=translation.photons,
        adc_bailout=translation.depth.adc_bailout,
        views=tuple(views),
    )


def _runs(translation: Translation, views: Sequence[ObservationView]) -> Iterator[PovrayRun]:
    """One run for each half image and exposure."""
    own, close = SceneText(translation), [(view, SceneText(seen_by(translation, view))) for view in views]
    for half in translation.lighting.halves:
        for shown in translation.mode.exposures:
            plain = replace(shown, half=half)
            yield _run(own, close, replace(plain, light_factor=light_factor(translation, plain)))


def _run(own: SceneText, close: Sequence[tuple[ObservationView, SceneText]], exposure: Exposure) -> PovrayRun:
    translation, half = own.translation, exposure.half
    shoots = translation.photons is not None and own.has_light(exposure)
    sky, settings = own.sky_picture(exposure), translation.settings

    def picture(text: SceneText, samples: int, view: str = "") -> PovrayPicture:
        grid, image = half_grids(samples)[half], text.translation.scene.image
        scene = text.sdl(exposure, "load_file" if shoots else "", sky)
        return PovrayPicture(view, scene, image.width * grid.across, image.height * grid.down, grid.across, grid.down)

    return PovrayRun(
        name="_".join(part for part in (half, exposure.name) if part),
        half=half,
        pictures=(
            picture(own, settings.samples),
            *(picture(text, view.samples, view.name) for view, text in close),
        ),
        photon_scene=own.sdl(exposure, "save_file", sky) if shoots else None,
        gain=exposure.gain,
        max_trace_level=translation.depth.level,
        adc_bailout=translation.depth.adc_bailout,
        depth_is_proven=translation.depth.is_proven,
        sky=sky,
    )
