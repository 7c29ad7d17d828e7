"""A job: one scene with what it requires and how much work is to be done for it. Every rendering begins here.

    job = prepare(load(path))                 # load, plan, settings
    lowered = job.lowered(EngineName.TRACER)  # lower
    rendering = run(job, Tracer(), folder)    # lower and run

Each of the values in between can be printed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Literal, assert_never, overload

from vitrail.base.changed import changed
from vitrail.base.engine_name import EngineName
from vitrail.geometry.world import World
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for, settings_for_views
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Quality, Settings
from vitrail.plan.views import PICTURE_SAMPLES, PICTURE_WIDTH, ObservationView, for_people, token, views_of
from vitrail.scene.load import Loaded
from vitrail.scene.model import Scene

if TYPE_CHECKING:
    from vitrail.lower.povray import PovrayScene


@dataclass(frozen=True)
class Job:
    """One scene that can be lowered and rendered. ``world`` is its geometry; it holds the scene that is rendered.

    ``overrides`` are the settings that somebody asked for; ``views`` the pictures that are made beside the scene's own.
    """

    loaded: Loaded = field(repr=False)
    world: World = field(repr=False)
    plan: Plan
    settings: Settings
    overrides: Mapping[str, object] = field(default_factory=dict)
    views: tuple[ObservationView, ...] = ()
    planner: Callable[[World], Plan] = field(default=analyse, repr=False)

    @property
    def scene(self) -> Scene:
        """The scene that is rendered."""
        return self.world.scene

    def with_scene(self, scene: Scene) -> Job:
        """The same plan and settings for a changed scene."""
        return replace(self, world=self.world.with_scene(scene))

    def with_views(self, picture_width: int = PICTURE_WIDTH) -> Job:
        """The same job with a view for every observed patch, and with the settings that go with views.

        The scene's own picture is then for people, and for whoever looks for differences outside the patches. It has
        ``picture_width`` pixels across at least, and never fewer than the scene says.
        """
        aimed = views_of(self.world, self.plan, self.settings)
        # A view has finer pixels than the picture: what stays below one there may be seen here.
        plan = self.plan.with_plans([self.planner(self._seen_by(view)) for view in aimed])
        settings = settings_for_views(self.world, plan, self.settings.quality, **self.overrides)
        views = views_of(self.world, plan, settings, fixed_samples="samples" in self.overrides)
        image = for_people(self.scene.image, picture_width)
        return replace(self.with_scene(changed(self.scene, image=image)), plan=plan, settings=settings, views=views)

    def _seen_by(self, view: ObservationView) -> World:
        return self.world.with_scene(changed(self.scene, camera=view.camera, image=view.image))

    def only(self, samples: Mapping[str, int]) -> Job:
        """The same job for some views alone, each with so many samples of a pixel; its picture is a token."""
        views = tuple(replace(view, samples=samples[view.name]) for view in self.views if view.name in samples)
        return replace(self.with_scene(changed(self.scene, image=token(self.scene.image))), views=views)

    @property
    def times(self) -> int:
        """How many pixels the picture has for one that the file says, along an edge."""
        return self.scene.image.width // self.loaded.scene.image.width

    @property
    def picture_settings(self) -> Settings:
        """Those of the scene's own picture: where all is measured in views it is for people and has few samples."""
        return changed(self.settings, samples=PICTURE_SAMPLES) if self.views else self.settings

    @overload
    def lowered(self, engine: Literal[EngineName.TRACER], *, wavelength_nm: float | None = None) -> dict[str, Any]: ...
    @overload
    def lowered(self, engine: Literal[EngineName.POVRAY]) -> PovrayScene: ...
    @overload
    def lowered(self, engine: EngineName) -> dict[str, Any] | PovrayScene: ...
    def lowered(self, engine: EngineName, *, wavelength_nm: float | None = None) -> dict[str, Any] | PovrayScene:
        """What the engine reads. ``wavelength_nm`` asks the tracer for light of that one wavelength.

        Raises NotTranslatable, with the scene's lines, for what POV-Ray cannot express.
        """
        # Load a back end when it is asked for: a command that emits for one engine starts faster without the other.
        match engine:
            case EngineName.TRACER:
                from vitrail.lower.tracer import lower_tracer

                return lower_tracer(
                    self.world, self.plan, self.picture_settings, views=self.views, wavelength_nm=wavelength_nm
                )
            case EngineName.POVRAY:
                from vitrail.lower.povray import lower_povray

                return lower_povray(self.world, self.plan, self.picture_settings, self.views)
            case _:
                assert_never(engine)


def prepare(
    loaded: Loaded,
    quality: Quality = Quality.NORMAL,
    overrides: Mapping[str, object] | None = None,
    *,
    planner: Callable[[World], Plan] = analyse,
) -> Job:
    """Plan a scene and settle how much work is done; ``overrides`` replace settings by name.

    ``planner`` is ``analyse``, or ``everything`` to leave nothing out. Raises the Fault of a setting that cannot be.
    """
    world = World.of(loaded)
    plan = planner(world)
    asked = dict(overrides or {})
    return Job(loaded, world, plan, settings_for(world, plan, quality, **asked), asked, planner=planner)
