"""A translation seen by the camera of a view: everything but camera and picture size stays as it is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vitrail.base.changed import unchecked
from vitrail.base.vector import length
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.normalise import FARTHEST_CAMERA, Normalisation
from vitrail.lower.povray.refusals.refusal import NotTranslatable, Refusals
from vitrail.lower.povray.translation import Translation
from vitrail.plan.views import ObservationView


def seen_by(translation: Translation, view: ObservationView) -> Translation:
    """The same bodies, lights, photons and depth before another camera."""
    scene = unchecked(translation.scene, camera=view.camera, image=view.image)
    return replace(translation, world=translation.world.with_scene(scene))


def refuse_distant_views(world: World, units: Normalisation, views: Sequence[ObservationView]) -> None:
    """Turn away observations whose camera, moved along with them, is so far that POV-Ray loses digits [P 7]."""
    place = {entry.name: index for index, entry in enumerate(world.scene.observe)}
    refusals, remedy = Refusals(world.loaded), "observe something nearer to the scene; POV-Ray loses digits there"
    found = [
        refusals.at("the camera of this observation is too far from the scene", remedy, "observe", place[name])
        for view in views
        if length(units.point(view.camera.position)) > FARTHEST_CAMERA
        for name in view.observations
    ]
    if found:
        raise NotTranslatable(found)
