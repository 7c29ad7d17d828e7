"""Do the intervals keep their word? Pairs of renderings that differ in the seed alone, judged as two programs.

Nothing deviates between them but noise, so with no tolerance at all a comparison is a false alarm whenever its interval
leaves out the ideal. A suite of n comparisons at false-alarm rate p, each at the level of Sidak's correction, may raise
one in at most a share p of the pairs.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

from scipy import stats

from vitrail.base.canonical_json import canonical_json
from vitrail.base.engine_name import EngineName
from vitrail.base.progress import Progress, silent
from vitrail.base.record import Record, write_record
from vitrail.engines.base import Engine
from vitrail.geometry.world import World
from vitrail.images.exr import ImageLayers, read_image
from vitrail.judge.comparison import Pair
from vitrail.judge.false_alarms import sidak
from vitrail.judge.observe import observe
from vitrail.judge.references import SceneTruth
from vitrail.judge.shown import Shown
from vitrail.pipeline.campaign import Campaign, Work, run_campaign
from vitrail.pipeline.job import Job, prepare
from vitrail.pipeline.run import run
from vitrail.pipeline.task import Task
from vitrail.plan.settings import Quality
from vitrail.scene.load import Loaded

RATES = (0.01, 0.05, 0.2)
"""The suite's own rate, and two at which a few hundred pairs can show whether the intervals are too narrow."""


class PairNumber(Record):
    """One number between two renderings, with its noise."""

    metric: str = ""
    difference: float
    standard_error: float
    degrees_of_freedom: float


class PairNumbers(Record):
    """The result of one task: every number of one pair that has any noise."""

    numbers: tuple[PairNumber, ...]


class AlarmRate(Record):
    """How many suites raise a false alarm at a stated rate.

    ``p_value``: the chance of so many or more alarms if the rate held exactly; below 0.01 the intervals are too narrow.
    """

    rate: float
    suites: int
    alarms: int
    p_value: float


class EqualRuns(Record):
    """``equal_runs.json``; ``failures`` are the words of pairs that could not be rendered."""

    vitrail_equal_runs: Literal[1] = 1
    scene: str
    failures: tuple[str, ...]
    rates: tuple[AlarmRate, ...]

    @property
    def pairs(self) -> int:
        """How many pairs were rendered."""
        return max(row.suites for row in self.rates)


def equal_runs(
    loaded: Loaded,
    out: Path,
    engine: Engine,
    *,
    pairs: int = 200,
    overrides: Mapping[str, object],
    progress: Progress = silent,
) -> EqualRuns:
    """Render and compare ``pairs`` pairs, remembering those that are done; write and return equal_runs.json."""
    # The files of a scene have other paths on another machine: the key of a task names them as the scene does.
    job = _job(loaded, overrides, 0)
    job = replace(job, world=World.of_scene(job.scene))
    content = canonical_json(job.lowered(EngineName.TRACER))
    tasks = [
        Task("pair", {"first": 2 * k + 1, "second": 2 * k + 2, "content": content, "version": engine.version()})
        for k in range(pairs)
    ]
    work: dict[str, Work] = {
        "pair": lambda spec: (_pair(loaded, engine, overrides, (spec["first"], spec["second"])).model_dump(), {})
    }
    rows = run_campaign(Campaign(tasks, work), out, progress=progress)
    suites = [PairNumbers.model_validate(row.result).numbers for row in rows if row.result is not None]
    found = EqualRuns(
        scene=loaded.path.stem,
        failures=tuple(row.failure for row in rows if row.failure),
        rates=tuple(alarm_table(suites)),
    )
    write_record(found, out / "equal_runs.json")
    return found


def alarm_table(suites: Sequence[Sequence[PairNumber]]) -> list[AlarmRate]:
    """For each rate: how many suites raise a false alarm, and whether that is more than the rate allows."""
    table = []
    for rate in RATES:
        alarms = sum(_alarms(suite, rate) for suite in suites)
        p_value = float(stats.binom.sf(alarms - 1, len(suites), rate)) if suites else 1.0
        table.append(AlarmRate(rate=rate, suites=len(suites), alarms=alarms, p_value=p_value))
    return table


def _alarms(suite: Sequence[PairNumber], rate: float) -> bool:
    """Whether any interval of the suite leaves out the ideal."""
    level = sidak(rate, len(suite)).level
    for number in suite:
        reach = float(stats.t.isf((1 - level) / 2, number.degrees_of_freedom)) * number.standard_error
        if abs(number.difference) > reach:
            return True
    return False


def _pair(loaded: Loaded, engine: Engine, overrides: Mapping[str, object], seeds: tuple[int, int]) -> PairNumbers:
    """Every number between two renderings of the scene."""
    job = _job(loaded, overrides, seeds[0])
    first, second = (_rendered(_job(loaded, overrides, seed), engine) for seed in seeds)
    shown = {
        name: Shown(view.camera, view.image, {"candidate": first[view.name], "reference": second[view.name]})
        for view in job.views
        for name in view.observations
    }
    radius_m = job.settings.gather_radius_m
    observed = observe(loaded.scene, {}, (Pair.CANDIDATE_REFERENCE,), SceneTruth(), radius_m, shown)
    numbers = tuple(
        PairNumber(
            metric=f"{each.observation.name}.{entry.metric}",
            difference=entry.value - entry.ideal,
            standard_error=entry.noise.standard_error,
            degrees_of_freedom=min(entry.noise.degrees_of_freedom, 1e9),
        )
        for each in observed
        for entry in each.measured
        if entry.noise.standard_error > 0
    )
    return PairNumbers(numbers=numbers)


def _job(loaded: Loaded, overrides: Mapping[str, object], seed: int) -> Job:
    """The views of the scene, each as a comparison has it; the picture is a token, as nobody looks at it."""
    job = prepare(loaded, Quality.DRAFT, {**overrides, "seed": seed}).with_views()
    return job.only({view.name: view.samples for view in job.views})


def _rendered(job: Job, engine: Engine) -> dict[str, ImageLayers]:
    """The image of every view, by its name."""
    with tempfile.TemporaryDirectory(prefix="vitrail-pair-") as work:
        made = run(job, engine, Path(work), threads=1)
        return {name: read_image(path) for name, path in made.views.items()}
