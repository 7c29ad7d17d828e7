"""Views by any renderer: what it is told to make, and how its pictures are judged."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.commands.command_line import run
from tests.pipeline.test_score import GREY, card  # noqa: F401
from vitrail.base.canonical_json import canonical_json
from vitrail.images.exr import ImageError, write_image
from vitrail.judge.comparison import Pair, Verdict
from vitrail.judge.records import Results, Status
from vitrail.pipeline.foreign_views import LIST, emitted_views
from vitrail.pipeline.job import prepare
from vitrail.pipeline.score import score
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash


def listed(card: Loaded) -> list[dict[str, object]]:  # noqa: F811
    return json.loads(emitted_views(prepare(card))[LIST])["views"]


def written(card: Loaded, folder: Path, scale: float = 1.0) -> Path:  # noqa: F811
    """The pictures of an even grey card, ``scale`` times as bright as the formula says."""
    folder.mkdir()
    for view in listed(card):
        write_image(folder / str(view["image"]), np.full((view["height"], view["width"], 3), 0.5 * scale))  # type: ignore[arg-type]
    return folder


def scored(card: Loaded, **folders: Path) -> Results:  # noqa: F811
    return score(card, {}, card.path.parent / "out", views=folders)


def test_each_view_has_a_scene_of_its_own_with_its_camera_and_size(card: Loaded) -> None:  # noqa: F811
    files = emitted_views(prepare(card))
    told = json.loads(files[LIST])
    whole = json.loads(files["scene.json"])
    assert told["scene_hash"] == whole["scene_hash"] == scene_hash(card.scene)
    assert [view["name"] for view in told["views"]] == [view["name"] for view in whole["views"]]
    for view, lowered in zip(told["views"], whole["views"], strict=True):
        alone = json.loads(files[view["scene"]])
        assert alone["camera"] == view["camera"] == lowered["camera"] != whole["camera"]
        assert alone["image"] == {"width": view["width"], "height": view["height"]}
        assert alone["settings"]["samples"] == view["samples"] and "views" not in alone
        assert canonical_json({key: alone[key] for key in ("objects", "lights", "materials")}) == canonical_json(
            {key: whole[key] for key in ("objects", "lights", "materials")}
        )


def test_emit_views_writes_what_a_renderer_needs(card: Loaded, tmp_path: Path) -> None:  # noqa: F811
    done = run("emit", "views", card.path, "--out", tmp_path / "work")
    assert done.exit_code == 0, done.output
    names = {LIST, "scene.json", *(str(view["scene"]) for view in listed(card))}
    assert {path.name for path in (tmp_path / "work").iterdir()} == names


def test_views_alone_are_judged_by_closed_forms_and_by_another_renderer(card: Loaded, tmp_path: Path) -> None:  # noqa: F811
    ours, theirs = written(card, tmp_path / "theirs"), written(card, tmp_path / "ours")
    results = scored(card, candidate=ours, reference=theirs)
    (scene,) = results.scenes
    (observation,) = scene.observations
    assert results.exit_code == 0 and not scene.images
    assert {entry.pair for entry in observation.comparisons} == {
        Pair.CANDIDATE_REFERENCE,
        Pair.CANDIDATE_TRUTH,
        Pair.REFERENCE_TRUTH,
    }
    assert observation.view is not None and [image.side for image in observation.view.images] == [
        "candidate",
        "reference",
    ]
    assert all((card.path.parent / "out" / image.exr).is_file() for image in observation.view.images)


def test_a_view_that_is_too_bright_deviates_though_the_picture_is_right(card: Loaded, tmp_path: Path) -> None:  # noqa: F811
    write_image(tmp_path / "whole.exr", GREY)
    views = {"candidate": written(card, tmp_path / "views", 1.02)}
    results = score(card, {"candidate": tmp_path / "whole.exr"}, tmp_path / "out", views=views)
    (scene,) = results.scenes
    assert scene.verdict is Verdict.DEVIATES and scene.images, "the views are measured, the picture is shown"
    assert f"--views {tmp_path / 'views'}" in scene.reproduce


def test_a_view_of_another_size_closes_a_gate(card: Loaded, tmp_path: Path) -> None:  # noqa: F811
    folder = written(card, tmp_path / "views")
    write_image(folder / str(listed(card)[0]["image"]), GREY[:7])
    results = scored(card, candidate=folder)
    assert results.scenes[0].status is Status.GATE_FAILED and results.exit_code == 2
    assert "candidate" in results.scenes[0].message


def test_a_missing_view_is_named_with_what_lists_it(card: Loaded, tmp_path: Path) -> None:  # noqa: F811
    (tmp_path / "empty").mkdir()
    with pytest.raises(ImageError, match="lacks .*exr; render what `vitrail emit views` lists"):
        scored(card, candidate=tmp_path / "empty")


def test_foreign_views_need_proof_as_foreign_pictures_do(card: Loaded, tmp_path: Path) -> None:  # noqa: F811
    views = {"candidate": written(card, tmp_path / "views")}
    results = score(card, {}, tmp_path / "out", views=views, needs_proof=True)
    assert results.scenes[0].status is Status.GATE_FAILED
    assert "has not shown that it conforms" in results.scenes[0].message


def test_score_wants_an_image_or_views(card: Loaded, tmp_path: Path) -> None:  # noqa: F811
    done = run("score", card.path, "--out", tmp_path / "out")
    assert done.exit_code == 2 and "--views" in done.output
