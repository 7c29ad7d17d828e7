"""Each observation is measured in a picture of its own; the scene's picture is for people."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.pipeline.doubles import CARD, FormulaEngine
from tests.pipeline.test_compare import RULES, TRUTH, only, run
from vitrail.base.changed import changed
from vitrail.engines.base import Rendering
from vitrail.geometry.camera import View
from vitrail.images.coarser import averaged
from vitrail.images.exr import read_image, write_image
from vitrail.judge.comparison import Pair, Verdict
from vitrail.judge.records import Status
from vitrail.pipeline.defect import Defect
from vitrail.pipeline.job import prepare
from vitrail.pipeline.lowered import lower
from vitrail.pipeline.request import Request
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded, load
from vitrail.scene.model import Scene
from vitrail.scene.print import scene_hash

CORNER = "{name: corner, phenomenon: diffusion, patch: {center: [0.3, 0, 0.3], u: [0.1, 0, 0], v: [0, 0, -0.1]}}"
TWO = CARD.replace("observe: [", f"observe: [{CORNER}, ")


class Viewed(FormulaEngine):
    """An engine whose picture of the view ``card`` is ``factor`` times as bright as all else."""

    factor = 1.0

    def render(self, *args, **rest) -> Rendering:
        made = super().render(*args, **rest)
        for name, path in made.views.items():
            image = read_image(path)
            factor = self.factor if name == "card" else 1.0
            light = (image.radiance * factor, image.half_a * factor, image.half_b * factor)
            write_image(path, light[0], half_a=light[1], half_b=light[2], metadata=image.metadata)
        return made


@pytest.fixture
def card(tmp_path: Path) -> Loaded:
    (tmp_path / "references").mkdir()
    (tmp_path / "references" / "thresholds.yaml").write_text(RULES)
    (tmp_path / "references" / "analytic.yaml").write_text(TRUTH)
    (tmp_path / "card.yaml").write_text(TWO)
    return load(tmp_path / "card.yaml")


def test_what_only_a_view_shows_decides_its_observation_and_no_other(tmp_path: Path, card: Loaded) -> None:
    tracer = Viewed("tracer")
    tracer.factor = 1.1
    scene = only(run(tmp_path, [card], tracer=tracer))
    assert [(entry.name, entry.verdict) for entry in scene.observations] == [
        ("corner", Verdict.AGREES),
        ("card", Verdict.DEVIATES),
    ]
    ratio = next(
        entry.value
        for entry in scene.observations[1].comparisons
        if entry.metric == "radiance_ratio.red" and entry.pair is Pair.TRACER_POVRAY
    )
    assert ratio == pytest.approx(1.1)
    # Where it lives is sought in the views too: the mean light of the patch is that of the view.
    assert scene.observations[1].where is not None
    without = only(run(tmp_path / "without", [card], tracer=tracer, views=False))
    assert without.verdict is Verdict.AGREES


def test_the_record_of_a_view_says_where_it_looks_from_and_holds_its_pictures(tmp_path: Path, card: Loaded) -> None:
    scene = only(run(tmp_path, [card]))
    view = scene.observations[0].view
    assert view is not None and (view.name, view.kind) == ("corner", "orthographic")
    assert (view.position, view.look_at) == ((0.3, 1.0, 0.3), (0.3, 0.0, 0.3))
    for side in view.images:
        image = read_image(tmp_path / "out" / side.exr)
        assert (image.width, image.height) == (view.width, view.height)
        assert (tmp_path / "out" / side.png).is_file()
    assert (tmp_path / "out" / view.difference_picture).is_file()
    x, y = zip(*view.outline_px, strict=True)
    assert min(x) >= 3 and max(x) <= view.width - 3 and min(y) >= 3 and max(y) <= view.height - 3
    assert [gate.message for gate in scene.gates if gate.gate == "view"] == ["corner: passed", "card: passed"]


def test_the_picture_is_for_people_and_still_shows_this_scene(tmp_path: Path, card: Loaded) -> None:
    scene = only(run(tmp_path, [card]))
    assert (scene.width, scene.height) == (480, 480)
    image = read_image(tmp_path / "out" / scene.images[0].exr)
    assert (image.width, image.height) == (480, 480)
    assert image.metadata["vitrail:scene_hash"] == scene.scene_hash == scene_hash(card.scene)
    # The outline of a patch is where the large picture shows it.
    assert scene.observations[1].patch.outline_px == ((144, 336), (336, 336), (336, 144), (144, 144))
    plain = only(run(tmp_path / "plain", [card], views=False))
    assert (plain.width, plain.observations[0].view) == (32, None)
    small = only(run(tmp_path / "small", [card], picture_width=1))
    assert (small.width, small.height) == (32, 32)
    assert small.observations[0].view == scene.observations[0].view
    assert "--no-views" in plain.reproduce and "--no-views" not in scene.reproduce


def test_a_view_that_an_engine_left_out_or_spoiled_is_a_failure_of_that_engine(tmp_path: Path, card: Loaded) -> None:
    class Blind(FormulaEngine):
        def render(self, *args, **rest) -> Rendering:
            return replace(super().render(*args, **rest), views={})

    scene = only(run(tmp_path, [card], povray=Blind("povray")))
    assert scene.status is Status.ENGINE_FAILED
    assert "povray: it made no picture of the view `corner`" in scene.message

    def spoil(image: np.ndarray) -> np.ndarray:
        image[2, 1, 0] = np.nan if image.shape[0] < 480 else image[2, 1, 0]
        return image

    spoiled = only(run(tmp_path / "spoiled", [card], tracer=FormulaEngine("tracer", spoil=spoil)))
    assert spoiled.status is Status.ENGINE_FAILED
    assert "tracer.corner.exr has nan at pixel x=1 y=2" in spoiled.message


def test_a_patch_may_be_black_where_the_picture_may_not(tmp_path: Path, card: Loaded) -> None:
    tracer = Viewed("tracer")
    tracer.factor = 0.0
    scene = only(run(tmp_path, [card], tracer=tracer))
    assert scene.status is Status.JUDGED and scene.verdict is Verdict.DEVIATES


def test_who_misreads_the_camera_misreads_that_of_every_view(card: Loaded, tmp_path: Path) -> None:
    def upside_down(scene: Scene) -> Scene:
        return changed(scene, camera=changed(scene.camera, up=(0.0, 0.0, 1.0)))

    job = prepare(card, Quality.DRAFT).with_views()
    request = Request(out=tmp_path, defect=Defect("turned", misread_by_povray=upside_down))
    lowered = lower(job, request)
    meant = [View.of(view.camera, view.image).up for view in job.views]
    assert [tuple(view["camera"]["up"]) for view in lowered.tracer["views"]] == meant
    assert lowered.povray is not None
    for view, up in zip(lowered.povray.views, meant, strict=True):
        assert View.of(view.camera, view.image).up == tuple(-each for each in up)


def test_pixels_are_averaged_in_squares() -> None:
    pixels = np.arange(4 * 6 * 3, dtype=float).reshape(4, 6, 3)
    small = averaged(pixels, 2)
    assert small.shape == (2, 3, 3)
    assert small[0, 1, 0] == pixels[:2, 2:4, 0].mean()
