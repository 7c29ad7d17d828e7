"""The program itself, as a person or a CI job calls it: exit codes, files, words."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from tests.end_to_end.conftest import ROOT
from vitrail.images.exr import read_image, write_image, write_png

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

CARD = ROOT / "scenes" / "calibration" / "grey_card_directional.yaml"
LENS = ROOT / "scenes" / "calibration" / "ball_lens.yaml"


def vitrail(*arguments: object, **environment: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "vitrail.commands.app", *map(str, arguments)]
    known = {**os.environ, "PYTHONPATH": str(ROOT / "compare"), **environment}
    return subprocess.run(command, capture_output=True, text=True, env=known, cwd=ROOT, timeout=600, check=False)


def test_compare_writes_a_report_and_results_that_fit_the_schema(tmp_path: Path) -> None:
    done = vitrail("compare", CARD, "--out", tmp_path, "--quality", "draft", "--json")
    assert done.returncode == 0, done.stderr
    printed = json.loads(done.stdout)
    written = json.loads((tmp_path / "results.json").read_text())
    assert printed == written
    jsonschema.validate(written, json.loads((ROOT / "references" / "results.schema.json").read_text()))
    for name in ("index.html", "grey_card_directional/index.html", "grey_card_directional/tracer.exr",
                 "grey_card_directional/povray.exr", "grey_card_directional/tracer.png"):  # fmt: skip
        assert (tmp_path / name).is_file(), f"{name} is missing"
    again = vitrail("report", tmp_path)
    assert again.returncode == 0 and again.stdout.strip() == str(tmp_path / "index.html")


def test_runs_on_other_numbers_of_threads_have_the_same_verdicts_and_numbers(tmp_path: Path) -> None:
    texts = set()
    for threads in (1, 2, 7):
        out = tmp_path / str(threads)
        vitrail("compare", LENS, "--out", out, "--quality", "draft", "--threads", threads, "--rounds", 0)
        results = json.loads((out / "results.json").read_text())
        # Take out what measures the machine and not the scene.
        del results["run"]
        for scene in results["scenes"]:
            del scene["engines"], scene["speed"]
            for key in ("cpu_s", "reason"):
                (scene["more_samples"] or {}).pop(key, None)
        assert [scene["verdict"] for scene in results["scenes"]] != [None]
        texts.add(json.dumps(results))
    assert len(texts) == 1


def test_a_wrong_scene_stops_everything_before_anything_is_touched(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text(CARD.read_text().replace("diffuse", "difuse"))
    done = vitrail("compare", CARD, wrong, "--out", tmp_path / "out")
    assert done.returncode == 2
    assert "wrong.yaml:" in done.stderr and "did you mean `diffuse`?" in done.stderr
    assert not (tmp_path / "out").exists()


def test_a_folder_without_scenes_is_no_success(tmp_path: Path) -> None:
    done = vitrail("compare", tmp_path, "--out", tmp_path / "out")
    assert done.returncode == 2 and "no scene found" in done.stderr


def test_povray_missing_is_an_engine_that_failed(tmp_path: Path) -> None:
    done = vitrail("compare", CARD, "--out", tmp_path / "out", "--quality", "draft", PATH=str(tmp_path))
    assert done.returncode == 4
    results = json.loads((tmp_path / "out" / "results.json").read_text())
    assert "there is no program `povray`" in results["scenes"][0]["message"]


def test_an_interruption_keeps_the_finished_scenes(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "vitrail.commands.app", "compare", str(CARD), str(LENS), "--out", str(tmp_path)]
    known = {**os.environ, "PYTHONPATH": str(ROOT / "compare")}
    options = ["--quality", "draft", "--set", "photons=8000000", "--rounds", "0", "--verbose"]
    child = subprocess.Popen([*command, *options], env=known, cwd=ROOT, stderr=subprocess.PIPE, text=True)
    assert child.stderr is not None
    for line in child.stderr:
        if line.startswith("ball_lens"):
            break
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    child.communicate(timeout=120)
    assert child.returncode == 130
    results = json.loads((tmp_path / "results.json").read_text())
    assert results["run"]["interrupted"]
    assert [scene["name"] for scene in results["scenes"] if scene["verdict"]] == ["grey_card_directional"]


@pytest.fixture(scope="module")
def card_image(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("card") / "card.exr"
    done = vitrail("render", CARD, "--out", out, "--quality", "draft")
    assert done.returncode == 0, done.stderr
    return out


def test_score_judges_images_of_any_program(tmp_path: Path, card_image: Path) -> None:
    same = vitrail("score", CARD, card_image, card_image, "--out", tmp_path / "same")
    assert same.returncode == 0, same.stderr
    pixels = read_image(card_image)
    write_image(tmp_path / "brighter.exr", pixels.radiance * 1.02, metadata=pixels.metadata)
    done = vitrail("score", CARD, tmp_path / "brighter.exr", card_image, "--out", tmp_path / "out", "--json")
    assert done.returncode == 1, done.stderr
    results = json.loads(done.stdout)
    (observation,) = results["scenes"][0]["observations"]
    assert observation["verdict"] == "deviates"
    assert observation["attribution"]["engine"] == "candidate"
    assert (tmp_path / "out" / "index.html").is_file()


def test_an_eight_bit_picture_is_no_radiance(tmp_path: Path, card_image: Path) -> None:
    picture = tmp_path / "card.png"
    write_png(picture, np.full_like(read_image(card_image).radiance, 0.5))
    done = vitrail("score", CARD, picture, card_image, "--out", tmp_path / "out")
    assert done.returncode == 2 and "holds uint8 pixels" in done.stdout
