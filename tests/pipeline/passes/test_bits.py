"""The same passes give the same bits, however many sittings and threads they took; foreign ones are refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.pipeline.passes.small_job import glowing_ball, job, passes
from vitrail.engines.tracer import Tracer
from vitrail.images.exr import ImageLayers, read_image
from vitrail.pipeline.passes.checkpoint import CheckpointError, checkpoint_path
from vitrail.pipeline.passes.passes_job import PassesJob

pytestmark = pytest.mark.tracer


def assert_same_bits(first: ImageLayers, second: ImageLayers) -> None:
    assert first.layers.keys() == second.layers.keys()
    for name in ("radiance", "half_a", "half_b", "variance"):
        np.testing.assert_array_equal(getattr(first, name), getattr(second, name))
    for name in first.layers:
        np.testing.assert_array_equal(first.layers[name], second.layers[name])
    ours, theirs = ({k: v for k, v in each.metadata.items() if k.startswith("vitrail:")} for each in (first, second))
    assert ours == theirs and "vitrail:passes" in ours


@pytest.mark.parametrize("make", [job, glowing_ball], ids=["photons", "nothing random"])
def test_one_sitting_on_one_thread_and_two_on_two_give_the_same_bits(make, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    passes(make(tmp_path / "one.exr"), 5)
    passes(make(tmp_path / "two.exr", threads=2), 2)
    done = passes(make(tmp_path / "two.exr"), 5, resume=True)
    assert done.record is not None and done.record["passes"]["count"] == 5
    assert_same_bits(read_image(tmp_path / "one.exr"), read_image(tmp_path / "two.exr"))


def test_one_pass_is_the_plain_rendering(tmp_path: Path) -> None:
    work = job(tmp_path / "one.exr")
    passes(work, 1)
    plain = read_image(Tracer().render(work.lowered, tmp_path / "plain", threads=1).image_path)
    one = read_image(work.out)
    for name in ("radiance", "half_a", "half_b"):
        np.testing.assert_array_equal(getattr(one, name), getattr(plain, name))
    assert one.layers.keys() == plain.layers.keys()


def test_the_layers_of_the_mean_sum_to_its_radiance(tmp_path: Path) -> None:
    work = job(tmp_path / "image.exr")
    passes(work, 3)
    image = read_image(work.out)
    # Each layer of each pass is rounded to single precision.
    np.testing.assert_allclose(sum(image.layers.values()), image.radiance, rtol=2**-21)
    np.testing.assert_allclose((image.half_a + image.half_b) / 2, image.radiance, rtol=2**-21)


def foreign(work: PassesJob, **settings: object) -> PassesJob:
    return with_lowered(work, settings={**work.lowered["settings"], **settings})


def with_lowered(work: PassesJob, **changes: object) -> PassesJob:
    """The same job, lowered to something else."""
    other = replace(work)
    vars(other)["lowered"] = {**work.lowered, **changes}
    return other


def test_a_foreign_checkpoint_is_refused_with_what_differs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    work = job(tmp_path / "image.exr", photons=500, pixels=8)
    passes(work, 1)
    kept = checkpoint_path(work.out).read_bytes()
    with pytest.raises(
        CheckpointError, match=r"image\.passes\.npz: holds passes with other settings \(seed 1 and not 2"
    ):
        passes(foreign(work, seed=2), 2, resume=True)
    with pytest.raises(CheckpointError, match="holds passes of another scene"):
        passes(with_lowered(work, scene_hash="0" * 64), 2, resume=True)
    with pytest.raises(CheckpointError, match="whose meshes, images of the sky or plan were others"):
        passes(with_lowered(work, title="other"), 2, resume=True)
    monkeypatch.setattr("vitrail.pipeline.passes.passes_job.build_of", lambda engine: "vitrail-tracer 9 (abc)")
    with pytest.raises(CheckpointError, match=r"of another tracer \(vitrail-tracer .*, not vitrail-tracer 9 \(abc\)\)"):
        passes(work, 2, resume=True)
    assert checkpoint_path(work.out).read_bytes() == kept


def test_a_checkpoint_that_is_missing_or_damaged_is_refused(tmp_path: Path) -> None:
    work = job(tmp_path / "image.exr", photons=500, pixels=8)
    with pytest.raises(CheckpointError, match="there is no checkpoint to resume; leave --resume out"):
        passes(work, 1, resume=True)
    passes(work, 1)
    place = checkpoint_path(work.out)
    place.write_bytes(place.read_bytes()[:-100])
    with pytest.raises(CheckpointError, match="is no checkpoint that can be read"):
        passes(work, 2, resume=True)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["image.exr", "image.passes.npz", "image.run.json"]
