"""Which solver `auto` stands for: by lights, faces and photons per pixel, with the reason in words."""

from __future__ import annotations

import pytest

from tests.plan.small_scenes import FLOOR, SUN, ball_over_floor, make
from vitrail.geometry.world import World
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.plan.solver_choice import SolverChoice, solver_choice
from vitrail.scene.model import Scene

WIDE_SUN = "{name: sun, directional: {direction: [0, -1, 0], irradiance: 3, angular_diameter_deg: 0.5}}"
PANEL = "{name: panel, area: {rectangle: {center: [0, 6, 0], u: [0, 0, 1], v: [1, 0, 0]}, radiance: 5}}"


def chosen(scene: Scene, **settings: object) -> SolverChoice | None:
    plan = analyse(World.of_scene(scene))
    asked = {"solver": "auto", **settings}
    return solver_choice(scene, plan, settings_for(World.of_scene(scene), plan, **asked))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("material", "lights", "photons", "solver", "because"),
    [
        ("clear", (SUN,), 10_000, "beams", "smooth faces, and one ray from each place of sun"),
        ("clear", (PANEL, SUN), 10_000, "beams", "smooth faces, and one ray from each place of sun"),
        ("clear", (WIDE_SUN,), 40_000, "light_bins", "every light has an extent, and 4 photons per pixel are enough"),
        ("clear", (WIDE_SUN,), 39_000, "photon_map", "every light has an extent, and 3.9 photons per pixel"),
        ("frosted", (SUN,), 200_000, "light_bins", "a face is rough, and 20 photons per pixel are enough"),
    ],
)
def test_auto_is_settled_by_lights_faces_and_photons(
    material: str, lights: tuple[str, ...], photons: int, solver: str, because: str
) -> None:
    found = chosen(ball_over_floor(material, lights=lights), photons=photons)
    assert found is not None
    assert found.solver == solver
    assert found.because.startswith(because)


def test_what_is_asked_for_is_taken() -> None:
    assert chosen(ball_over_floor(), solver="photon_map") == SolverChoice("photon_map", "asked for")  # type: ignore[arg-type]


def test_a_scene_without_a_caustic_has_no_solver() -> None:
    assert chosen(make(FLOOR)) is None
