"""Which solver of caustics `auto` stands for in a scene, and why; the tracer settles it by the same rules."""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from vitrail.base.phenomenon import Phenomenon
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Settings, Solver
from vitrail.scene.model import Area, Directional, Environment, Light, Point, Scene, Spot

PHOTONS_FOR_BINS = 4
"""Photons per pixel from which they are counted in pixels, where no light can go as beams. As in the tracer."""


@dataclass(frozen=True)
class SolverChoice:
    """A solver, never ``auto``, and the reason in words."""

    solver: Solver
    because: str


def solver_choice(scene: Scene, plan: Plan, settings: Settings) -> SolverChoice | None:
    """The solver that the tracer takes; None without photons. The run record says it again, lamp by lamp.

    Light whose rays part or divide too often goes as photons, which a pilot of the tracer finds out.
    """
    if settings.photons == 0:
        return None
    if settings.solver is not Solver.AUTO:
        return SolverChoice(settings.solver, "asked for")
    if not plan.requires(Phenomenon.ROUGHNESS):
        alone = [light.name for light in scene.lights if _sends_rays_alone(light)]
        if alone:
            return SolverChoice(Solver.BEAMS, f"smooth faces, and one ray from each place of {', '.join(alone)}")
        reason = "every light has an extent"
    else:
        reason = "a face is rough"
    per_pixel = settings.photons / (scene.image.width * scene.image.height)
    enough = per_pixel >= PHOTONS_FOR_BINS
    return SolverChoice(
        Solver.LIGHT_BINS if enough else Solver.PHOTON_MAP,
        f"{reason}, and {per_pixel:.3g} photons per pixel are {'enough' if enough else 'too few'} to count in pixels",
    )


def _sends_rays_alone(light: Light) -> bool:
    """Whether one ray alone leaves each place of a light, or each direction."""
    emitter = light.emitter
    match emitter:
        case Directional():
            return emitter.angular_diameter_deg == 0
        case Point() | Spot():
            return True
        case Area():
            return emitter.collimated
        case Environment():
            return False
        case _:
            assert_never(emitter)
