"""A scene as POV-Ray will have it: the value between the scene and its text, from which the certificate is made too."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from vitrail.geometry.world import World
from vitrail.lower.povray.asked import Asked
from vitrail.lower.povray.bodies.contact import Joined, with_contacts
from vitrail.lower.povray.bodies.gaps import Placement, with_gaps
from vitrail.lower.povray.bodies.meshes import refuse_unreadable_meshes
from vitrail.lower.povray.bodies.nesting import Nesting, nesting_of
from vitrail.lower.povray.bodies.normalise import Normalisation, in_metres, normalise
from vitrail.lower.povray.photons.depth import TraceDepth, trace_depth
from vitrail.lower.povray.photons.off_centre import off_centre
from vitrail.lower.povray.photons.photons import Ball, PhotonPass, Shooting, photon_pass, photon_targets
from vitrail.lower.povray.refusals.horizon import refuse_unseen_planes
from vitrail.lower.povray.refusals.layers import refuse_nested_layers
from vitrail.lower.povray.refusals.refusal import Refusals
from vitrail.lower.povray.refusals.support import refuse_unsupported
from vitrail.lower.povray.text.emitters import Grid
from vitrail.lower.povray.text.indices import Indices
from vitrail.lower.povray.text.lights import Source, sources
from vitrail.lower.povray.text.modes import Mode, mode_of
from vitrail.lower.povray.text.sky import Skies, skies_of
from vitrail.plan.plan import Plan
from vitrail.plan.reduced import reduced
from vitrail.plan.settings import Quality, Settings
from vitrail.scene.model import Scene

EMITTERS: dict[Quality, int] = {Quality.DRAFT: 13, Quality.NORMAL: 21, Quality.REFERENCE: 89}
"""Small lights that stand for one with a surface or a solid angle, in each half image."""


@dataclass(frozen=True)
class Bodies:
    """The bodies made fit for POV-Ray: their units, where each stands, who is cut by whom, who grew into whom."""

    units: Normalisation
    joined: Joined
    placement: Placement
    nesting: Nesting


@dataclass(frozen=True)
class Lighting:
    """The small lights of both half images, and the images of skies."""

    halves: Mapping[str, tuple[Source, ...]]
    skies: Skies


@dataclass(frozen=True)
class Translation:
    """Everything that decides what POV-Ray is told and how exact that is; ``world`` has its contacts as overlaps."""

    world: World
    plan: Plan
    settings: Settings
    bodies: Bodies
    mode: Mode
    indices: Indices
    lighting: Lighting
    photons: PhotonPass | None
    depth: TraceDepth

    @property
    def scene(self) -> Scene:
        return self.world.scene

    @property
    def units(self) -> Normalisation:
        return self.bodies.units

    def shooting(self, half: str) -> Shooting | None:
        """The lights of a half image with the photons they shoot; None without photons."""
        return Shooting(self.world, self.lighting.halves[half], self.photons) if self.photons is not None else None


def translate(world: World, plan: Plan, settings: Settings, *, is_readable: bool = False) -> Translation:
    """Refuse what POV-Ray cannot do, make bodies fit, choose the mode, aim lights and photons, in this order.

    ``is_readable`` keeps metres wherever POV-Ray's tolerances resolve the scene in them. Raises NotTranslatable with
    the lines of the scene's file.
    """
    refusals = Refusals(world.loaded)
    asked = Asked(world.with_scene(reduced(world.scene, plan)), plan, settings, refusals)
    refuse_unsupported(asked)
    refuse_unreadable_meshes(asked.world, refusals)
    skies = skies_of(asked.scene, world.folder or Path(), refusals)
    bodies = _bodies(asked, is_readable=is_readable)
    asked = replace(asked, world=bodies.joined.world)
    refuse_unseen_planes(asked.world, bodies.units, asked.refusals)
    mode = mode_of(asked.scene, plan, settings, skies)
    refuse_nested_layers(asked, bodies.nesting, mode)
    targets = photon_targets(asked, bodies.units)
    lighting = _lighting(asked, bodies.units, skies, targets)
    return Translation(
        world=asked.world,
        plan=plan,
        settings=settings,
        bodies=bodies,
        mode=mode,
        indices=Indices(asked.scene, mode.bands, mode.is_sliced),
        lighting=lighting,
        photons=photon_pass(asked, lighting.halves["a"], targets, bodies.units, len(mode.bands)),
        depth=trace_depth(asked),
    )


def _bodies(asked: Asked, *, is_readable: bool) -> Bodies:
    """Units first: what touches what, and by how much it must not, is a matter of them."""
    radius = asked.settings.gather_radius_m if asked.has_caustic else 0.0
    units = normalise(asked.world, asked.refusals, radius)
    if is_readable:
        units = in_metres(asked.world, units)
    joined = with_contacts(asked.world, units)
    placement = with_gaps(joined.world, units, joined.contacts)
    return Bodies(units, joined, placement, nesting_of(joined.world, units, joined.pairs))


def _lighting(asked: Asked, units: Normalisation, skies: Skies, targets: tuple[Ball, ...]) -> Lighting:
    """The small lights of both half images: lattices that are shifted apart at random."""
    grid = Grid(EMITTERS[asked.settings.quality], asked.settings.seed)
    halves = {
        half: off_centre(sources(asked, units, replace(grid, is_second=is_second), skies), targets, is_second)
        for half, is_second in {"a": False, "b": True}.items()
    }
    return Lighting(halves, skies)
