"""The whole text of one execution: settings, camera, lights, objects, in this order."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from vitrail.base.colour import Triplet
from vitrail.lower.povray.photons.radiosity import radiosity_sdl
from vitrail.lower.povray.text.camera import camera_sdl
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.lights import Source, light_sdl
from vitrail.lower.povray.text.objects import ObjectText
from vitrail.lower.povray.text.sdl import Block, Directive, SdlFile, Statement, block, rgb, statement
from vitrail.lower.povray.text.sky import SkyPicture
from vitrail.lower.povray.translation import Translation
from vitrail.scene.model import Ambient, Environment

DARK = (statement("ambient", 0), statement("emission", 0), statement("diffuse", 0))
"""The finish of what says nothing else; POV-Ray's own has light of its own [P 1.1]."""


@dataclass(frozen=True)
class SceneText:
    """Writes the executions of a translated scene."""

    translation: Translation

    @cached_property
    def _objects(self) -> ObjectText:
        return ObjectText(self.translation)

    def sdl(self, exposure: Exposure, photon_file: str, sky: SkyPicture | None) -> SdlFile:
        """The tree; ``photon_file`` says what happens to the photon map, and without it there are no photons."""
        translation = self.translation
        bodies, is_shooting = translation.bodies, photon_file == "save_file"
        found = translation.photons
        photons = found.sdl(exposure.half, photon_file) if found is not None and photon_file else None
        objects = self._objects
        lights = translation.lighting.halves[exposure.half]
        return SdlFile(
            (
                Directive("version", 3.7),
                self._globals(exposure, photons),
                block("#default", block("finish", *DARK)),
                self.background(exposure, sky),
                camera_sdl(translation.world.view, translation.units),
                *(light_sdl(source, exposure) for source in lights if _shines(source, exposure)),
                *(
                    objects.sdl(index, shape, exposure, is_shooting)
                    for index, shape in enumerate(bodies.placement.placed)
                    if index not in bodies.nesting.omitted
                ),
            )
        )

    def background(self, exposure: Exposure, sky: SkyPicture | None) -> Block:
        """What a ray sees that meets nothing."""
        return block("background", statement(rgb(exposure.light(self._sky())))) if sky is None else sky.sdl

    def sky_picture(self, exposure: Exposure) -> SkyPicture | None:
        """What a ray of a run sees that meets nothing, where that is an image."""
        found = [sky.picture(exposure, self._sky()) for sky in self.translation.lighting.skies.values()]
        return found[0] if found else None

    def has_light(self, exposure: Exposure) -> bool:
        """Whether any light shines in the channel of a run."""
        return any(_shines(source, exposure) for source in self.translation.lighting.halves[exposure.half])

    def settings(self, exposure: Exposure) -> Block:
        """The global settings of a run that shoots its own photons and uses them at once."""
        photons = self.translation.photons
        return self._globals(exposure, photons.sdl(exposure.half) if photons is not None else None)

    def _globals(self, exposure: Exposure, photons: Block | None) -> Block:
        scene, depth, quality = self.translation.scene, self.translation.depth, self.translation.settings.quality
        has_radiosity = scene.transport.indirect == "photons"
        return block(
            "global_settings",
            statement("assumed_gamma", 1),
            statement("max_trace_level", depth.level),
            statement("adc_bailout", depth.adc_bailout),
            self._ambient(exposure),
            radiosity_sdl(scene, quality, exposure.half) if has_radiosity else None,
            photons,
        )

    def _ambient(self, exposure: Exposure) -> Statement | None:
        """The constant irradiance of ``indirect: {ambient: c}``; surfaces answer to it with ``ambient 1``."""
        indirect = self.translation.scene.transport.indirect
        if not isinstance(indirect, Ambient):
            return None
        red, green, blue = exposure.light(indirect.ambient)
        return statement("ambient_light", rgb((red / math.pi, green / math.pi, blue / math.pi)))

    def _sky(self) -> Triplet:
        """What a ray sees that meets nothing: the constant environments."""
        skies = [light.emitter for light in self.translation.scene.lights if isinstance(light.emitter, Environment)]
        found = [sky.radiance for sky in skies if sky.radiance is not None]
        red, green, blue = (math.fsum(sky[channel] for sky in found) for channel in range(3))
        return (red, green, blue)


def _shines(source: Source, exposure: Exposure) -> bool:
    return max(exposure.share(source.strength)) > 0
