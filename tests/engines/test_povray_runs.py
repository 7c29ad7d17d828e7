"""The real POV-Ray inside our walls: private folder and home, no foreign settings, a full record, a clean end."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, lowered, rendered, scene
from vitrail.engines.child import run_child
from vitrail.engines.isolate import Allowance, isolate
from vitrail.engines.povray import Povray
from vitrail.images.exr import read_image
from vitrail.scene.load import Loaded

pytestmark = pytest.mark.povray

CARD = "- {name: c, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}"


def card() -> Loaded:
    return scene("card: {diffuse: 0.5}", CARD)


def test_foreign_settings_are_not_obeyed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """[P 12.19] ./povray.ini, $POVINI and the home's are read by a POV-Ray that is started plainly."""
    home = tmp_path / "home"
    (home / ".povray" / "3.7").mkdir(parents=True)
    for path in (tmp_path / "povray.ini", home / ".povray" / "3.7" / "povray.ini", tmp_path / "named.ini"):
        path.write_text("Width=16\nHeight=16\nQuality=1\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.setenv("POVINI", str(tmp_path / "named.ini"))
    seen = rendered(card())
    assert seen.image.radiance.shape == (32, 32, 3)
    assert seen.mean[0] == pytest.approx(0.5, rel=HALF_FLOAT)


def test_the_image_has_the_layout_of_both_engines(tmp_path: Path) -> None:
    made = Povray().render(lowered(card()), tmp_path)
    image = read_image(made.image_path)
    assert made.image_path == tmp_path / "povray.exr" and image.pixel_type == "float"
    assert image.half_a is not None and image.half_b is not None and image.variance is not None
    assert len(str(image.metadata["vitrail:scene_hash"])) == 64
    assert json.loads(str(image.metadata["vitrail:settings"]))["samples"] == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["povray", "povray.exr", "povray.run.json"]
    assert json.loads((tmp_path / "povray.run.json").read_text()) == json.loads(json.dumps(made.record))


def test_the_record_says_what_was_done() -> None:
    objects = """
    - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: floor}
    - {name: ball, sphere: {center: [0, 1, 0], radius: 0.3}, material: clear}
    """
    loaded = scene("floor: {diffuse: 0.5}\nclear: {transmission: 1, ior: 1.5}", objects)
    record = rendered(loaded, photons=20_000).record
    assert record["vitrail_run"] == 1 and record["engine"] == "povray" and record["version"].startswith("3.")
    counters, cpu = record["counters"], record["cpu_s"]
    assert 10_000 < counters["photons_emitted"] < 80_000
    assert 0 < counters["photons_stored"] <= counters["photons_emitted"]
    assert counters["camera_rays"] >= 2 * 32 * 32 and counters["shadow_rays"] > 0
    assert cpu["total"] >= cpu["photon_pass"] > 0 and record["wall_s"] > 0
    assert record["peak_memory_bytes"] > 1 << 20
    assert record["settings"]["photons_used"] == counters["photons_emitted"]
    assert {entry["phenomenon"] for entry in record["certificate"]} >= {"caustic", "diffusion"}
    assert record["isolation"] and record["interrupted"] is False


def test_photon_flux_of_the_main_path_is_stored_exactly() -> None:
    """A clear ball passes every photon on: stored flux times gain is the light on its disc.

    Rays within 0.16 % of the rim turn by more than 90 degrees and never meet the floor: 0.326 % of the light. The rest
    is the noise of a jittered lattice, 0.1 % with 40 000 photons.
    """
    objects = """
    - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: floor}
    - {name: ball, sphere: {center: [0, 2, 0], radius: 1}, material: clear}
    """
    loaded = scene("floor: {diffuse: 0.5}\nclear: {transmission: 1, ior: 1.5}", objects)
    seen = rendered(loaded, photons=100_000)
    for run in seen.record["runs"]:
        flux = run["photons"]["flux_units"][0] * run["gain"][0] / seen.lowered.normalisation.scale**2
        assert flux == pytest.approx(np.pi * (1 - 0.00326), rel=2e-3)


def test_the_walls_hold(tmp_path: Path) -> None:
    """Inside, the environment and the home are private; as root, the user is nobody and the network is gone."""
    folder = tmp_path / "inside"
    folder.mkdir()
    os.environ["VITRAIL_SECRET"] = "visible"
    try:
        isolated = isolate(Path("/bin/sh"), ["-c", "env; pwd; id -u; cat /proc/net/dev"], folder, Allowance())
        said = run_child(isolated.command).stdout
    finally:
        del os.environ["VITRAIL_SECRET"]
    assert "VITRAIL_SECRET" not in said and f"HOME={folder}" in said
    if "no network" in isolated.walls:
        assert "eth" not in said and "lo:" in said
    if "user without rights" in isolated.walls:
        assert "\n65534\n" in said


def test_a_program_that_eats_processor_time_is_ended(tmp_path: Path) -> None:
    isolated = isolate(Path("/bin/sh"), ["-c", "while :; do :; done"], tmp_path, Allowance(cpu_s=1))
    finished = run_child(isolated.command)
    assert finished.code != 0 and finished.cpu_s < 5


def test_progress_goes_up_to_the_whole_work(tmp_path: Path) -> None:
    steps: list[tuple[str, float, float]] = []
    Povray().render(lowered(card()), tmp_path, threads=1, progress=lambda *step: steps.append(step))
    assert steps and all(done <= total for _, done, total in steps)
    assert steps[-1][1] == steps[-1][2]


def test_runs_at_a_time_do_not_change_the_picture(tmp_path: Path) -> None:
    made = [Povray().render(lowered(card()), tmp_path / str(n), threads=n) for n in (1, 2)]
    first, second = (read_image(each.image_path).radiance for each in made)
    assert np.array_equal(first, second)


def test_runs_with_the_same_text_are_executed_once() -> None:
    """Without photons and lamps the halves are the same picture; its cost counts once."""
    record = rendered(card()).record
    assert [run["is_repeated"] for run in record["runs"]] == [False, True]
    assert record["counters"]["camera_rays"] == 32 * 32
