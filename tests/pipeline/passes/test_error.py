"""The error of a mean of passes: it falls as it should, it stops the passes, and closed forms lie within it."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from tests.pipeline.doubles import FormulaEngine
from tests.pipeline.passes.small_job import glowing_ball, job, passes
from vitrail.base.progress import Progress, silent
from vitrail.engines.base import Rendering
from vitrail.images.exr import read_image
from vitrail.judge.half_error import HalfError, Scatter
from vitrail.pipeline.passes.checkpoint import checkpoint_path, read_checkpoint
from vitrail.pipeline.passes.error_estimate import ErrorEstimate
from vitrail.pipeline.passes.run import Finished
from vitrail.pipeline.passes.schedule import blur_radius_m
from vitrail.pipeline.passes.stop import Reason, StopCriteria, Target, is_spent, next_look, passes_wanted

pytestmark = [pytest.mark.tracer, pytest.mark.slow]

FLUX = 0.8 * 0.716163303479 * math.pi
"""W/sr of the ball lens within 0.9 m: d E / pi times pi b(0.9)^2, E = pi [O 1.6], as in references/analytic.yaml."""

RING, BRIGHTEST = "annulus_mean.0", 6.80294823202
"""Within 0.05 m of the axis [O 1.6], W sr^-1 m^-2, as in references/analytic.yaml."""


def number(done: Finished, metric: str) -> HalfError:
    return next(each for each in done.errors if each.metric == metric)


def test_noise_falls_as_the_root_of_the_passes_and_the_flux_is_the_closed_form(tmp_path: Path) -> None:
    """Counted in pixels there is no disc, and each pass adds as much as the one before."""
    done = passes(job(tmp_path / "image.exr", solver="light_bins"), 16)
    assert done.record is not None
    noise = done.record["passes"]["noise"]
    # 600 lit pixels of one channel know their root mean square to 1 / sqrt(1200) = 3 % each; three of that.
    assert noise[0] / noise[3] == pytest.approx(2, rel=0.13)
    assert noise[0] / noise[15] == pytest.approx(4, rel=0.13)
    flux = number(done, "caustic_flux.green")
    assert flux.blur == 0
    assert abs(flux.value - FLUX) <= flux.half_width + flux.pixel_blur
    assert flux.half_width < 0.005 * FLUX


def test_passes_refine_edges_where_nothing_is_random(tmp_path: Path) -> None:
    """A ball of 0.4 m fills pi 0.4^2 of the image of 1 m: the area from 16 passes is off by less than that of one."""
    off = []
    for count in (1, 16):
        work = glowing_ball(tmp_path / f"{count}.exr")
        passes(work, count)
        off.append(abs(read_image(work.out).radiance - read_image(work.out).radiance.round()))
    # An edge pixel that was looked through twice knows halves; one that was looked through 32 times knows shares.
    shares = np.unique(off[1])
    assert set(np.unique(off[0])) == {0.0, 0.5} and len(shares) > 10
    area = read_image(tmp_path / "16.exr").radiance[..., 0].mean()
    # About 60 edge pixels, each known to 0.3 / sqrt(32): sqrt(60) 0.05 / 576 pixels; three of that.
    assert area == pytest.approx(math.pi * 0.4**2, abs=3 * math.sqrt(60) * 0.3 / math.sqrt(32) / 576)


def test_the_blur_of_the_disc_goes_away_and_is_known_while_it_lasts(tmp_path: Path) -> None:
    """The brightest ring lacks what the disc carries out of it, in proportion to its mean square radius; beams, in the
    same pixels, lack nothing, and the closed form is as far again as pixels blur."""
    sharp = number(passes(job(tmp_path / "sharp.exr", 96, solver="beams", photons=40_000), 1), RING)
    assert abs(sharp.value - BRIGHTEST) < sharp.pixel_blur
    lacks, rings = [], []
    for count in (1, 30):
        done = passes(job(tmp_path / f"{count}.exr", 96, photons=20_000, gather_radius_m=0.04), count)
        rings.append(number(done, RING))
        lacks.append(sharp.value - rings[-1].value)
        assert 0 < lacks[-1] < rings[-1].blur + rings[-1].half_width
        assert abs(rings[-1].value - BRIGHTEST) < rings[-1].half_width + rings[-1].blur + rings[-1].pixel_blur
    expected = (blur_radius_m(1, 30) / blur_radius_m(1, 1)) ** 2
    doubt = sum(ring.half_width for ring in rings) / lacks[0]
    assert lacks[1] / lacks[0] == pytest.approx(expected, abs=doubt)
    assert expected + doubt < 0.9, "the test could not tell it from a disc that stays as it is"


def test_a_target_stops_at_the_first_look_that_meets_it_and_the_closed_form_lies_within(tmp_path: Path) -> None:
    estimates: list[ErrorEstimate] = []
    target = Target("caustic", "caustic_flux", 0.006)
    done = passes(job(tmp_path / "image.exr"), StopCriteria(targets=(target,)), on_estimate=estimates.append)
    assert done.reason is Reason.TARGET_ERROR and done.record is not None
    *before, last = [target.largest(estimate.errors) for estimate in estimates]
    assert last is not None and last.error <= 0.006
    assert before and all(each is not None and each.error > 0.006 for each in before)
    assert done.record["passes"]["count"] == estimates[-1].passes
    assert abs(last.value - FLUX) <= last.half_width + last.blur + last.pixel_blur
    # A met target stays met: nothing more is made for it.
    again = passes(job(tmp_path / "image.exr"), StopCriteria(targets=(target,)), resume=True)
    assert again.record is not None and again.record["passes"]["count"] == estimates[-1].passes
    stored = json.loads(str(read_image(tmp_path / "image.exr").metadata["vitrail:passes"]))
    assert stored["count"] == estimates[-1].passes and stored["errors"]


def test_estimates_between_sittings_are_those_of_one(tmp_path: Path) -> None:
    target = Target("caustic", "caustic_flux", 0.006)
    whole = passes(job(tmp_path / "one.exr"), StopCriteria(targets=(target,)))
    passes(job(tmp_path / "two.exr"), StopCriteria(passes=3, targets=(target,)))
    parts = passes(job(tmp_path / "two.exr"), StopCriteria(targets=(target,)), resume=True)
    assert whole.record is not None and parts.record is not None
    assert whole.record["passes"]["count"] == parts.record["passes"]["count"] > 3


def test_the_interval_is_never_narrower_than_the_scatter_of_the_passes(tmp_path: Path) -> None:
    """Sixteen numbers that are off by 1 leave their mean known to 1/4, and Student's t of 16 degrees is 2.12."""
    scatter = Scatter()
    for sign in [1, -1] * 8:
        assert scatter.count >= 4 or scatter.half_width("spot: r50") == 0
        scatter = scatter.with_moves({"spot: r50": sign})
    assert scatter.half_width("spot: r50") == pytest.approx(2.12 / 4, rel=1e-3)
    assert scatter.with_moves({}).half_width("spot: r50") == 0
    passes(job(tmp_path / "image.exr"), 4)
    work = job(tmp_path / "image.exr")
    kept = read_checkpoint(checkpoint_path(work.out), work.identity)
    found = {each.metric: each.half_width for each in passes(work, 4, resume=True).errors}
    assert kept.scatter.count == 4
    assert all(found[key.split(": ")[1]] >= kept.scatter.half_width(key) > 0 for key in kept.scatter.squares)


class Priced(FormulaEngine):
    """Two CPU seconds a rendering."""

    def render(self, lowered: object, out_dir: Path, *, threads: int = 0, progress: Progress = silent) -> Rendering:
        made = super().render(lowered, out_dir, threads=threads, progress=progress)
        whole = {"wall_s": 2.0, "peak_memory_bytes": 1, "warnings": [], "process": {}, "ledger": {}}
        process = {"cpu_s": 2.0, "wall_s": 2.0, "peak_memory_bytes": 1}
        ledger = {name: [0, 0, 0] for name in ("emitted", "stored", "absorbed", "escaped", "truncated")}
        settings = {"settings": {"solver": "photon_map"}}
        record = {
            **made.record,
            **whole,
            **settings,
            "process": process,
            "ledger": {**ledger, "closure": 0},
            "camera_ledger": {"cut": 0},
        }
        return Rendering(made.image_path, record)


@pytest.mark.parametrize(("budget_s", "made"), [(0, 1), (3.9, 1), (4, 2), (9, 4)])
def test_a_budget_buys_what_fits_and_one_pass_always(budget_s: float, made: int, tmp_path: Path) -> None:
    engine = Priced("tracer", noise=0.1)
    work = job(tmp_path / "image.exr", engine=engine)
    done = passes(work, StopCriteria(budget_s=budget_s))
    assert (engine.renders, done.reason) == (made, Reason.BUDGET)
    assert done.record is not None
    assert done.record["process"]["cpu_s"] == 2 * made and done.record["counters"]["photons_emitted"] == 9000 * made


def test_a_budget_is_for_all_sittings_together(tmp_path: Path) -> None:
    passes(job(tmp_path / "image.exr", engine=Priced("tracer", noise=0.1)), StopCriteria(budget_s=4))
    engine = Priced("tracer", noise=0.1)
    passes(job(tmp_path / "image.exr", engine=engine), StopCriteria(budget_s=8), resume=True)
    assert engine.renders == 2


def test_the_next_look_is_where_the_target_should_be_met_and_never_beyond_twice_the_passes() -> None:
    error = HalfError("spot", "caustic", "r50", 1.0, "m", 0.03, 0.0, 0.0, 1.0)
    assert passes_wanted([Target("caustic", "", 0.01)], [error], 4) == 36
    assert passes_wanted([Target("caustic", "r90", 0.01)], [error], 4) is None
    assert [next_look(36, 4), next_look(6, 4), next_look(3, 4), next_look(None, 4)] == [8, 6, 5, 8]
    assert [next_look(2, 1), next_look(101, 100)] == [2, 125]
    assert is_spent(StopCriteria(), [1.0] * 1000) is None
