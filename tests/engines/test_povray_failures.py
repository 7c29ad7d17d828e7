"""A POV-Ray that is missing, old, broken, slow or silent: exit code 4 by way of EngineFailure, in its own words."""

from __future__ import annotations

import math
import stat
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.lower.povray.real_povray import lowered, rendered, scene
from vitrail.base.changed import changed
from vitrail.engines import povray as module
from vitrail.engines.base import EngineFailure
from vitrail.engines.child import Finished
from vitrail.engines.povray import Povray
from vitrail.engines.povray_output import statistics_of
from vitrail.engines.povray_result import Execution, Outcome, PhotonCensus
from vitrail.lower.povray import PovrayScene
from vitrail.lower.povray.text.sky import SkyPicture

pytestmark = pytest.mark.povray

Fake = Callable[[str], str]

BANNER = 'if [ "$1" = --version ]; then echo "POV-Ray 3.7.0.8" >&2; exit 0; fi\n'


@pytest.fixture
def fake(tmp_path: Path) -> Fake:
    """Write a shell script in the place of POV-Ray."""

    def write(body: str) -> str:
        program = tmp_path / "povray"
        program.write_text("#!/bin/sh\n" + body)
        program.chmod(program.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
        return str(program)

    return write


def card() -> PovrayScene:
    return lowered(
        scene("card: {diffuse: 0.5}", "- {name: c, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}")
    )


def test_a_missing_povray_is_named_with_the_way_to_get_it(tmp_path: Path) -> None:
    with pytest.raises(EngineFailure, match="no program `povray-of-nowhere`; install POV-Ray 3.7"):
        Povray("povray-of-nowhere").render(card(), tmp_path / "out")


def test_an_old_povray_is_refused(fake: Fake, tmp_path: Path) -> None:
    program = fake('echo "Persistence of Vision(tm) Ray Tracer"; echo "POV-Ray 3.6.1 (g++)" >&2\n')
    with pytest.raises(EngineFailure, match="version 3.6.1 is older than 3.7") as failure:
        Povray(program).render(card(), tmp_path / "out")
    assert "POV-Ray 3.6.1" in failure.value.said


def test_a_program_that_is_not_povray_is_refused(fake: Fake, tmp_path: Path) -> None:
    with pytest.raises(EngineFailure, match="does not say its version") as failure:
        Povray(fake('echo "hello, I am something else"\n')).render(card(), tmp_path / "out")
    assert "something else" in failure.value.said


def test_a_parse_error_is_quoted(fake: Fake, tmp_path: Path) -> None:
    complaint = "File 'scene.pov' line 3: Parse Error: Expected 'numeric expression', } found instead"
    program = fake(BANNER + f'echo "{complaint}" >&2\necho "Render failed" >&2\nexit 1\n')
    with pytest.raises(EngineFailure, match="exit code 1") as failure:
        Povray(program).render(card(), tmp_path / "out")
    assert complaint in failure.value.said and complaint in str(failure.value)


def test_a_crash_names_the_signal(fake: Fake, tmp_path: Path) -> None:
    program = fake(BANNER + 'echo "Parsing" >&2\nkill -SEGV $$\n')
    with pytest.raises(EngineFailure, match="SIGSEGV") as failure:
        Povray(program).render(card(), tmp_path / "out")
    assert "Parsing" in failure.value.said


def test_a_povray_that_hangs_is_stopped_with_all_its_children(fake: Fake, tmp_path: Path) -> None:
    program = fake(BANNER + 'echo "Rendering forever" >&2\nsleep 600 &\nwait\n')
    with pytest.raises(EngineFailure, match="stopped after") as failure:
        Povray(program, timeout_s=1.0).render(card(), tmp_path / "out")
    assert "Rendering forever" in failure.value.said


def test_a_povray_that_hangs_at_its_version_is_stopped(fake: Fake, tmp_path: Path) -> None:
    with pytest.raises(EngineFailure, match="asked for its version"):
        Povray(fake("sleep 600\n"), timeout_s=1.0).version()


def test_a_povray_that_writes_nothing_has_failed(fake: Fake, tmp_path: Path) -> None:
    program = fake(BANNER + 'echo "POV-Ray finished" >&2\nexit 0\n')
    with pytest.raises(EngineFailure, match="wrote no image") as failure:
        Povray(program).render(card(), tmp_path / "out")
    assert "POV-Ray finished" in failure.value.said


def test_a_povray_that_writes_rubbish_has_failed(fake: Fake, tmp_path: Path) -> None:
    program = fake(BANNER + "head -c 1000 /dev/urandom > image.exr\nexit 0\n")
    with pytest.raises(EngineFailure, match="image cannot be read"):
        Povray(program).render(card(), tmp_path / "out")


def test_a_failure_leaves_no_image(fake: Fake, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with pytest.raises(EngineFailure):
        Povray(fake(BANNER + "exit 1\n")).render(card(), out)
    assert not out.exists() or not list(out.iterdir())


UNDER_A_ROOF = """
    - {name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: floor}
    - {name: ball, sphere: {center: [0, 1, 0], radius: 0.3}, material: clear}
    - {name: roof, box: {min: [-20, 2, -20], max: [20, 2.1, 20]}, material: floor}
    """


def test_light_that_reaches_no_glass_is_a_remark_and_no_failure() -> None:
    """A roof is in the way: the floor is black in both engines, and neither stores a photon."""
    seen = rendered(scene("floor: {diffuse: 0.5}\nclear: {transmission: 1, ior: 1.5}", UNDER_A_ROOF), photons=10_000)
    assert seen.record["counters"]["photons_stored"] == 0 < seen.record["counters"]["photons_emitted"]
    assert "photons met a surface that scatters" in seen.record["warnings"][-1]
    assert not seen.image.radiance.any()


def test_light_that_leaves_the_scene_is_no_failure() -> None:
    """A lamp in a block of index 1 that stands over a card: what leaves the block upwards and sideways is lost.

    The rest lights the card in the block: E = I / h^2 under the lamp. 2e-3: the picture is 0.01 wide.
    """
    objects = """
    - {name: card, rectangle: {center: [0, 0, 0], u: [0, 0, 3], v: [3, 0, 0]}, material: card}
    - {name: block, box: {min: [-5, -0.5, -5], max: [5, 2, 5]}, material: block}
    """
    lamp = "- {name: lamp, point: {position: [0, 1, 0], intensity: 3}}"
    camera = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.01}"
    loaded = scene("card: {diffuse: 0.8}\nblock: {transmission: 1, ior: 1}", objects, lamp, camera)
    assert rendered(loaded, photons=10_000).mean[0] == pytest.approx(0.8 / math.pi * 3, rel=2e-3)


def test_photons_that_lost_their_light_are_a_failure() -> None:
    """[P 12.1] A flux that a photon cannot hold is stored as none."""
    ended = Finished(0, "", "", 0.0, 0.0, 0, interrupted=False, timed_out=False)
    shot = Execution(ended, "", statistics_of("Number of photons shot: 9000\nSurface photons stored: 100"), ())
    for stored in (0, 100):
        outcome = Outcome(card().runs[0], (), PhotonCensus(shot, stored, np.zeros(3), 0.0))
        with pytest.raises(EngineFailure, match="stored 100 photons and saved none with light"):
            Povray()._check_photons([outcome])


def test_a_sky_that_cannot_be_written_is_told(fake: Fake, tmp_path: Path) -> None:
    translated = card()
    skies = [replace(run, sky=SkyPicture("no folder/sky.exr", np.ones((2, 4, 3)))) for run in translated.runs]
    with pytest.raises(EngineFailure, match=r"sky cannot be written .*; free room there, or name another folder"):
        Povray(fake(BANNER)).render(replace(translated, runs=tuple(skies)), tmp_path / "out")


def test_a_povray_without_memory_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The real one, allowed less than it needs to start."""
    starved = replace(card(), settings=changed(card().settings, memory_limit_mb=1))
    monkeypatch.setattr(module, "EXTRA_MEMORY_BYTES", 1 << 20)
    with pytest.raises(EngineFailure, match="povray: it"):
        Povray().render(starved, tmp_path / "out")


def test_a_focus_brighter_than_half_floats_is_no_picture() -> None:
    """A lens in its focal distance over a card, and discs far smaller than its light: POV-Ray writes infinity."""
    lens = "lens: {radius_front: 0.5, radius_back: 0.5, thickness: 0.004, diameter: 0.04}"
    burning = scene(
        "card: {diffuse: 0.8}\nglass: {transmission: 1, ior: 1.5, fresnel: true}",
        f"""
        - {{name: card, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: card}}
        - {{name: lens, {lens}, rotate_deg: [90, 0, 0], translate: [0, 0.5013, 0], material: glass}}
        """,
        camera="camera: {kind: orthographic, position: [0, 0.3, 0], look_at: [0, 0, 0], up: [0, 0, 1], height: 5.0e-4}",
    )
    with pytest.raises(EngineFailure, match=r"samples are brighter than its half-float image holds.*gather_radius_m"):
        rendered(burning, photons=100_000, gather_radius_m=2e-5)
