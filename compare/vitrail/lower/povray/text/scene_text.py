"""The whole text of one execution: settings, camera, lights, objects, in this order."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.gaps import Placement
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.photons.depth import TraceDepth
from vitrail.lower.povray.photons.photons import PhotonPass
from vitrail.lower.povray.photons.radiosity import radiosity_sdl
from vitrail.lower.povray.text.camera import HALF_SHIFTS, camera_sdl
from vitrail.lower.povray.text.exposure import Exposure, Triplet
from vitrail.lower.povray.text.lights import Source, light_sdl
from vitrail.lower.povray.text.objects import ObjectText
from vitrail.lower.povray.text.sdl import Block, Directive, SdlFile, Statement, block, present, rgb, statement
from vitrail.lower.povray.text.sky import Skies, SkyPicture
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Quality
from vitrail.scene.model import Ambient, Environment, Scene

DARK = (statement("ambient", 0), statement("emission", 0), statement("diffuse", 0))
"""The finish of what says nothing else; POV-Ray's own has light of its own [P 1.1]."""


@dataclass(frozen=True)
class SceneText:
    """What all executions of a scene share; ``lights`` differ by half where they are grids."""

    world: World
    plan: Plan
    units: Normalisation
    lights: Mapping[str, tuple[Source, ...]]
    skies: Skies
    photons: PhotonPass | None
    depth: TraceDepth
    placement: Placement
    objects: ObjectText
    quality: Quality

    @property
    def scene(self) -> Scene:
        return self.world.scene

    def sdl(
        self, half: str, exposure: Exposure, samples_across: int, photon_file: str, sky: SkyPicture | None
    ) -> SdlFile:
        """The tree; ``photon_file`` says what happens to the photon map, and without it there are no photons."""
        is_shooting = photon_file == "save_file"
        return SdlFile(
            present(
                (
                    Directive("version", 3.7),
                    self._globals(half, exposure, photon_file),
                    block("#default", block("finish", *DARK)),
                    block("background", statement(rgb(exposure.light(self._sky())))) if sky is None else sky.sdl,
                    camera_sdl(self.world.view, samples_across, HALF_SHIFTS[half], self.units),
                    *(light_sdl(source, exposure) for source in self.lights[half] if _shines(source, exposure)),
                    *(
                        self.objects.sdl(index, shape, exposure, is_shooting)
                        for index, shape in enumerate(self.placement.placed)
                        if index not in self.objects.nesting.omitted
                    ),
                )
            )
        )

    def sky_picture(self, exposure: Exposure) -> SkyPicture | None:
        """What a ray of a run sees that meets nothing, where that is an image."""
        found = [sky.picture(exposure, self._sky()) for sky in self.skies.values()]
        return found[0] if found else None

    def has_light(self, half: str, exposure: Exposure) -> bool:
        """Whether any light shines in the channel of a run."""
        return any(_shines(source, exposure) for source in self.lights[half])

    def _globals(self, half: str, exposure: Exposure, photon_file: str) -> Block:
        has_radiosity = self.scene.transport.indirect == "photons"
        return block(
            "global_settings",
            statement("assumed_gamma", 1),
            statement("max_trace_level", self.depth.level),
            statement("adc_bailout", self.depth.adc_bailout),
            self._ambient(exposure),
            radiosity_sdl(self.scene, self.quality, half) if has_radiosity else None,
            self.photons.sdl(half, photon_file) if self.photons is not None and photon_file else None,
        )

    def _ambient(self, exposure: Exposure) -> Statement | None:
        """The constant irradiance of ``indirect: {ambient: c}``; surfaces answer to it with ``ambient 1``."""
        indirect = self.scene.transport.indirect
        if not isinstance(indirect, Ambient):
            return None
        red, green, blue = exposure.light(indirect.ambient)
        return statement("ambient_light", rgb((red / math.pi, green / math.pi, blue / math.pi)))

    def _sky(self) -> Triplet:
        """What a ray sees that meets nothing: the constant environments."""
        skies = [light.emitter for light in self.scene.lights if isinstance(light.emitter, Environment)]
        found = [sky.radiance for sky in skies if sky.radiance is not None]
        red, green, blue = (math.fsum(sky[channel] for sky in found) for channel in range(3))
        return (red, green, blue)


def _shines(source: Source, exposure: Exposure) -> bool:
    return max(exposure.share(source.strength)) > 0
