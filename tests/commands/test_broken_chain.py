"""A chain that is broken on purpose: whatever breaks is called by its own name, and nothing looks like success."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from tests.commands.command_line import ROOT, run
from vitrail.images.exr import write_image, write_png
from vitrail.scene.load import load
from vitrail.scene.print import scene_hash

CARD = ROOT / "scenes" / "calibration" / "grey_card_directional.yaml"
LIGHT = np.array([0.18, 0.5, 0.9]) * 3 * 0.8 / np.pi
"""The closed form of the scene."""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """The card in a project of its own, with good images of it as our tracer signs them."""
    scene = Path(shutil.copy(CARD, tmp_path / "card.yaml"))
    good = np.broadcast_to(LIGHT, (64, 96, 3)) * np.linspace(0.9, 1.1, 96)[:, None]
    signed = {"vitrail:engine": "tracer 0.1.0", "vitrail:scene_hash": scene_hash(load(scene).scene)}
    for name in ("candidate", "reference"):
        write_image(tmp_path / f"{name}.exr", good, metadata=signed)
    return tmp_path


def rewrite(change: Callable[[np.ndarray], np.ndarray], **metadata: str) -> Callable[[Path], Path]:
    """Put a changed reference in the place of the good one."""

    def broken(project: Path) -> Path:
        good = np.broadcast_to(LIGHT, (64, 96, 3)) * np.linspace(0.9, 1.1, 96)[:, None]
        signed = {"vitrail:engine": "tracer 0.1.0", **{f"vitrail:{key}": value for key, value in metadata.items()}}
        write_image(project / "reference.exr", change(good.copy()), metadata=signed)
        return project / "reference.exr"

    return broken


def with_nan(radiance: np.ndarray) -> np.ndarray:
    radiance[3, 4, 1] = np.nan
    return radiance


def eight_bits(project: Path) -> Path:
    write_png(project / "reference.png", np.full((64, 96, 3), 0.5))
    return project / "reference.png"


def cut_off(project: Path) -> Path:
    path = project / "reference.exr"
    path.write_bytes(path.read_bytes()[:400])
    return path


IMAGES = {
    "another exposure, as its header says": (rewrite(lambda x: 2 * x, exposure_stops="1"), "was exposed by 1 stops"),
    "another exposure, in silence": (rewrite(lambda x: 2 * x), "times", "at every pixel (-1.00 stops)"),
    "a pixel that is no number": (rewrite(with_nan), "has nan at pixel x=4 y=3 (channel G)"),
    "the wrong size": (rewrite(lambda x: x[:-1]), "is 96 x 63, the scene says 96 x 64"),
    "eight bits": (eight_bits, "holds uint8 pixels; write linear float or half"),
    "black": (rewrite(lambda x: 0 * x), "is black everywhere"),
    "of another scene": (rewrite(lambda x: x, scene_hash="b" * 64), "shows scene bbbbbbbbbbbb"),
    "cut off": (cut_off, "write it again"),
    "not there": (lambda project: project / "nothing.exr", "no such image"),
}


@pytest.mark.parametrize("case", IMAGES)
def test_a_broken_image_is_called_by_its_name(case: str, project: Path) -> None:
    broken, *words = IMAGES[case]
    done = run("score", project / "card.yaml", project / "candidate.exr", broken(project), "--out", project / "out")
    assert done.exit_code == 2, done.output
    assert all(each in " ".join(done.output.split()) for each in words), done.output


SCENES = {
    "a patch beside the picture": (
        ("center: [0, 0, 0], u", "center: [50, 0, 0], u"),
        "the patch is outside the picture",
    ),
    "a patch of nothing": (("u: [0.5, 0, 0]", "u: [0.00001, 0, 0]"), "leaves nothing to measure"),
    "a patch without an edge": (("u: [0.5, 0, 0]", "u: [0, 0, 0]"), "u"),
}


@pytest.mark.parametrize("case", SCENES)
def test_an_empty_patch_is_refused_before_anything_is_rendered(case: str, project: Path) -> None:
    (old, new), words = SCENES[case]
    scene = project / "card.yaml"
    text = scene.read_text()
    assert old in text
    scene.write_text(text.replace(old, new))
    done = run("compare", scene, "--out", project / "out")
    assert done.exit_code == 2 and words in done.output and not (project / "out").exists(), done.output


def test_a_missing_reference_is_no_success(project: Path) -> None:
    done = run("compare", project / "card.yaml", "--against", "stored", "--out", project / "out")
    assert done.exit_code == 2
    assert "there is no stored reference; accept one with `vitrail bless" in " ".join(done.output.split())


def test_no_scene_is_no_success(tmp_path: Path) -> None:
    done = run("compare", tmp_path, "--out", tmp_path / "out")
    assert done.exit_code == 2 and "no scene found" in done.output


def test_the_good_chain_holds(project: Path) -> None:
    """The same images, unbroken, are judged: what the other tests see is the break and nothing else."""
    done = run(
        "score", project / "card.yaml", project / "candidate.exr", project / "reference.exr", "--out", project / "out"
    )
    assert done.exit_code == 0, done.output
