"""``vitrail trace`` with the real tracer: a ray leaves a prism at the angle of the closed form, band by band."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from tests.commands.command_line import ROOT, run
from vitrail.optics.glass import glass_named

pytestmark = pytest.mark.tracer

PRISM = ROOT / "tests" / "golden" / "prism.yaml"
INDICES = (1.6, 1.632, 1.664, 1.696)


def deviation(index: float, incidence: float, apex: float = math.pi / 3) -> float:
    """i1 + i2 - A, with sin i2 = n sin(A - r1), sin i1 = n sin r1."""
    first = math.asin(math.sin(incidence) / index)
    return incidence + math.asin(index * math.sin(apex - first)) - apex


def turned(vertices: list[dict], start: tuple[float, float]) -> float:
    """The angle between the first and the last direction, in the plane of the prism."""
    x, y, _ = vertices[1]["direction_out"]
    return math.atan2(start[0] * y - start[1] * x, start[0] * x + start[1] * y)


def traced(incidence_deg: float, *options: str, scene: Path = PRISM) -> list[dict]:
    """A ray to the middle of the left face, whose outward normal is (-cos 30, sin 30), at this angle above it."""
    angle = math.radians(150 + 180 + incidence_deg)
    way = (math.cos(angle), math.sin(angle))
    middle = (-0.25, math.sqrt(3) / 12)
    origin = ",".join(repr(value) for value in (middle[0] - way[0], middle[1] - way[1], 0.0))
    direction = ",".join(repr(value) for value in (*way, 0.0))
    result = run("trace", scene, "--origin", origin, "--direction", direction, "--json", *options)
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout)["vertices"]


@pytest.mark.parametrize("band", range(4))
def test_each_band_leaves_a_prism_at_its_own_angle(band: int) -> None:
    """[O 1.5]: deviations at 55 degrees incidence, from 46.3242 for red to 56.2259 for blue."""
    incidence = math.radians(55)
    vertices = traced(55, "--band", str(band))
    start = (math.cos(math.radians(330 + 55)), math.sin(math.radians(330 + 55)))
    # Fifteen digits survive two refractions; 1e-12 leaves room for the turn of the frame.
    assert abs(turned(vertices, start)) == pytest.approx(deviation(INDICES[band], incidence), abs=1e-12)
    expected = (46.3242, 49.3747, 52.6486, 56.2259)[band]
    assert math.degrees(abs(turned(vertices, start))) == pytest.approx(expected, abs=5e-5)


def test_a_wavelength_has_the_index_of_its_glass(tmp_path: Path) -> None:
    scene = tmp_path / "sf10.yaml"
    text = PRISM.read_text(encoding="utf-8")
    scene.write_text(text.replace("ior: 1.6, dispersion: 0.032", "glass: SF10"), encoding="utf-8")
    vertices = traced(60, "--wavelength-nm", "486.1327", scene=scene)
    start = (math.cos(math.radians(390)), math.sin(math.radians(390)))
    expected = deviation(glass_named("SF10").line("F"), math.radians(60))
    assert abs(turned(vertices, start)) == pytest.approx(expected, abs=1e-12)


def test_the_table_for_people_names_the_vertices() -> None:
    result = run("trace", PRISM, "--origin", "-1,0,0", "--direction", "1,0,0")
    assert result.exit_code == 0
    assert "prism" in result.stdout
    assert "throughput" in result.stdout


def test_the_branch_and_the_number_of_vertices_are_chosen(tmp_path: Path) -> None:
    scene = tmp_path / "window.yaml"
    text = PRISM.read_text(encoding="utf-8")
    scene.write_text(text.replace("ior: 1.6, dispersion: 0.032", "ior: 1.6, fresnel: true"), encoding="utf-8")
    mirrored, through = (
        traced(55, "--branch", branch, "--max-vertices", "1", scene=scene) for branch in ("reflect", "transmit")
    )
    assert len(mirrored) == len(through) == 1
    # Mirrored at 55 degrees to the normal, the ray turns by 180 - 2 * 55.
    start = (math.cos(math.radians(385)), math.sin(math.radians(385)))
    x, y, _ = mirrored[0]["direction_out"]
    assert math.degrees(math.acos(start[0] * x + start[1] * y)) == pytest.approx(70, abs=1e-10)
    assert through[0]["direction_out"][0] > 0
