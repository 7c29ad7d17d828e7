"""A renderer of somebody else, from its first images to a verdict: the adapter guide, executed."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from tests.end_to_end.conftest import ROOT
from vitrail.geometry.world import World
from vitrail.judge.comparison import Verdict
from vitrail.judge.records import Results, SceneResult, Status
from vitrail.judge.reference_files import ReferencesError
from vitrail.lower.tracer import lower_tracer
from vitrail.pipeline.conformance import conformance_scenes
from vitrail.pipeline.score import score
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.load import Loaded, load

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

CARD = ROOT / "scenes" / "calibration" / "grey_card_point.yaml"


@pytest.fixture(scope="module")
def renderer() -> ModuleType:
    """docs/adapters/numpy_renderer.py, which the guide tells people to read."""
    spec = importlib.util.spec_from_file_location("numpy_renderer", ROOT / "docs" / "adapters" / "numpy_renderer.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def lowered(loaded: Loaded) -> dict[str, object]:
    world = World.of(loaded)
    plan = analyse(world)
    return json.loads(json.dumps(lower_tracer(world, plan, settings_for(world, plan))))


@pytest.fixture(scope="module")
def images(renderer: ModuleType) -> dict[str, np.ndarray]:
    """Its images of the conformance scenes and of the one that it is to be judged by."""
    return {each.path.stem: renderer.render(lowered(each)) for each in (*conformance_scenes(), load(CARD))}


Write = Callable[..., Path]


@pytest.fixture
def written(renderer: ModuleType, images: dict[str, np.ndarray], tmp_path: Path) -> Write:
    """Its images in a folder, each with a mistake in it or as it is."""

    def write(mistake: Callable[[np.ndarray], np.ndarray] = lambda radiance: radiance) -> Path:
        for name, radiance in images.items():
            renderer.write(str(tmp_path / f"{name}.exr"), mistake(radiance))
        return tmp_path

    return write


def judged(folder: Path, **rest: object) -> tuple[Results, SceneResult]:
    """Its image of the card by the closed form alone; the card stands last in the results."""
    results = score(load(CARD), {"candidate": folder / f"{CARD.stem}.exr"}, folder / "out", **rest)  # type: ignore[arg-type]
    return results, results.scenes[-1]


def test_its_program_makes_the_folder_of_the_guide(tmp_path: Path) -> None:
    """`images/camera.exr` of the guide, where no one made `images`: it once wrote nothing and said nothing."""
    scene = tmp_path / "scene.json"
    scene.write_text(json.dumps(lowered(load(CARD))), encoding="utf-8")
    program, image = ROOT / "docs" / "adapters" / "numpy_renderer.py", tmp_path / "images" / "card.exr"
    subprocess.run([sys.executable, program, scene, image], check=True)
    assert image.stat().st_size > 0


def test_a_renderer_that_conforms_is_judged(written: Write) -> None:
    folder = written()
    results, scene = judged(folder, conformance=folder, needs_proof=True)
    assert [(each.name, each.verdict) for each in results.scenes[:-1]] == [
        (name, Verdict.AGREES) for name in ("camera", "units", "colour")
    ]
    assert scene.status is Status.JUDGED and scene.observations[0].comparisons
    assert [gate.message for gate in scene.gates if gate.gate == "conformance"] == ["camera, units, colour agree"]
    assert scene.reproduce.endswith(f"--conformance {folder} --out out")


def test_without_proof_nothing_is_judged_unless_somebody_says_so(written: Write) -> None:
    folder = written()
    _, refused = judged(folder, needs_proof=True)
    assert refused.status is Status.GATE_FAILED and refused.exit_code == 2 and not refused.observations
    assert "has not shown that it conforms" in refused.message and "--conformance" in refused.message
    _, allowed = judged(folder)
    assert allowed.status is Status.JUDGED and "has not shown that it conforms" in allowed.warnings[0]


@pytest.mark.parametrize(
    ("mistake", "caught"),
    [
        (lambda radiance: radiance[:, ::-1], "camera deviates, units deviates, colour deviates"),
        (lambda radiance: radiance ** (1 / 2.2), "camera deviates, units deviates, colour deviates"),
        (lambda radiance: np.minimum(radiance, 10), "(colour deviates)"),
        (lambda radiance: radiance[..., ::-1], "camera deviates, colour deviates"),
    ],
    ids=["mirrored", "gamma", "clamped", "blue_for_red"],
)
def test_a_mistake_of_the_adapter_is_called_one(
    written: Write, mistake: Callable[[np.ndarray], np.ndarray], caught: str
) -> None:
    folder = written(mistake)
    _, scene = judged(folder, conformance=folder, needs_proof=True)
    assert scene.status is Status.GATE_FAILED and not scene.observations
    assert "the renderer does not conform" in scene.message and caught in scene.message


def test_a_missing_image_of_proof_is_named(written: Write) -> None:
    folder = written()
    (folder / "units.exr").unlink()
    with pytest.raises(ReferencesError, match="units.exr: missing; render scenes/conformance"):
        judged(folder, conformance=folder, needs_proof=True)


def test_an_image_of_a_scene_that_nothing_is_known_of_needs_a_reference(written: Write, tmp_path: Path) -> None:
    folder = written()
    own = tmp_path / "own.yaml"
    own.write_text(CARD.read_text())
    results = score(load(own), {"candidate": folder / f"{CARD.stem}.exr"}, tmp_path / "out")
    assert results.exit_code == 2 and "there is nothing to hold the image against" in results.scenes[0].message
