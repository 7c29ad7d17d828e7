"""``vitrail render`` by passes: until a budget is spent, an error is small enough, or somebody says stop."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from vitrail.base.exit_code import ExitCode
from vitrail.base.fault import Fault
from vitrail.commands.comparison_options import reference_errors
from vitrail.commands.errors import usage_error
from vitrail.commands.target_error import parse_target_error

if TYPE_CHECKING:
    from vitrail.judge.half_error import HalfError
    from vitrail.pipeline.job import Job
    from vitrail.pipeline.passes.error_estimate import ErrorEstimate
    from vitrail.pipeline.passes.run import Finished
    from vitrail.pipeline.passes.stop import StopCriteria, Target
    from vitrail.scene.load import Loaded

PASSES = typer.Option(None, "--passes", min=1, help="Make so many independent passes and average them.")
BUDGET_S = typer.Option(None, "--budget-s", min=0, help="Make passes for so many CPU seconds.")
TARGET_ERROR = typer.Option([], "--target-error", metavar="PHENOMENON=ERROR", help="Make passes until it is so small.")
RESUME = typer.Option(False, "--resume", help="Go on with the passes that were made before.")


@dataclass(frozen=True)
class PassOptions:
    """The options of passes as they were given."""

    passes: int | None
    budget_s: float | None
    target_error: list[str]
    resume: bool
    samples_given: bool

    @property
    def wanted(self) -> bool:
        """Whether the image is to be made from passes; raises typer.Exit for ``--resume`` alone."""
        ends = self.passes is not None or self.budget_s is not None or bool(self.target_error)
        if self.resume and not ends:
            raise usage_error("--resume: say when to stop; add --passes, --budget-s or --target-error")
        return ends


def render_passes(job: Job, threads: int, out: Path, options: PassOptions) -> tuple[Finished, int]:
    """Make the passes; what came of them, and the exit code."""
    from vitrail.commands.progress_bar import progress_bar
    from vitrail.engines.tracer import Tracer
    from vitrail.judge.references import read_scene_truth, references_folder
    from vitrail.judge.thresholds import thresholds_of
    from vitrail.pipeline.passes.checkpoint import CheckpointError, checkpoint_path
    from vitrail.pipeline.passes.interrupt import patient_interrupt
    from vitrail.pipeline.passes.passes_job import PassesJob
    from vitrail.pipeline.passes.run import run_passes
    from vitrail.pipeline.passes.schedule import pass_settings

    criteria, loaded = _stop_criteria(job.loaded, options), job.loaded
    try:
        settings = pass_settings(job.scene, job.settings, samples_given=options.samples_given)
    except Fault as fault:
        raise usage_error(f"--samples {job.settings.samples}: {fault}") from None
    out.parent.mkdir(parents=True, exist_ok=True)
    if not options.resume and checkpoint_path(out).is_file():
        typer.echo(f"{checkpoint_path(out)}: begins anew; --resume would go on with the passes in it", err=True)
    with reference_errors():
        references = references_folder(loaded.path)
        truth = read_scene_truth(references, loaded.path.stem, loaded.scene)
        first = replace(job, settings=settings)
        passes = PassesJob(first, out, truth, thresholds_of(references), Tracer(), threads)
        try:
            with progress_bar(out.stem) as show, patient_interrupt() as interrupt:
                say = lambda found: typer.echo(_estimate_line(found, criteria), err=True)  # noqa: E731
                done = run_passes(passes, criteria, interrupt, resume=options.resume, progress=show, on_estimate=say)
        except CheckpointError as error:
            raise usage_error(str(error)) from None
    for line in _pixel_lines(done, criteria):
        typer.echo(line, err=True)
    return done, _exit_code(done, criteria)


def _stop_criteria(loaded: Loaded, options: PassOptions) -> StopCriteria:
    from vitrail.pipeline.passes.stop import StopCriteria, Target

    observed = [entry.phenomenon.value for entry in loaded.scene.observe]
    remedy = "name one of them, or add an entry to `observe` that says where to look for it (scenes/README.md)"
    targets = [parse_target_error(text, observed, "the scene observes", remedy) for text in options.target_error]
    return StopCriteria(options.passes, options.budget_s, tuple(Target(*target) for target in targets))


def _estimate_line(estimate: ErrorEstimate, criteria: StopCriteria) -> str:
    """What is known after so many passes, and what is still to be expected."""
    known = ", ".join(_known(target, estimate.errors) for target in criteria.targets)
    start = f"{estimate.passes} passes, {estimate.cpu_s:.2g} CPU s: {known}"
    if estimate.wanted is None or estimate.wanted <= estimate.passes:
        return start
    more = estimate.wanted - estimate.passes
    return f"{start}; about {more} passes more, {more * estimate.cpu_s / estimate.passes:.2g} CPU s"


def _known(target: Target, errors: Sequence[HalfError]) -> str:
    worst = target.largest(errors)
    if worst is None:
        return f"{target} cannot be measured"
    return f"{target.phenomenon} {worst.error:.2g} ({worst.observation}: {worst.metric}), wanted {target.error:g}"


def _exit_code(done: Finished, criteria: StopCriteria) -> int:
    """130 after Ctrl-C, 5 where an error was wanted and something else ended the passes before."""
    from vitrail.pipeline.passes.stop import Reason

    if done.reason is Reason.INTERRUPTED:
        return ExitCode.INTERRUPTED
    return ExitCode.INCONCLUSIVE if criteria.targets and done.reason is not Reason.TARGET_ERROR else 0


def _pixel_lines(done: Finished, criteria: StopCriteria) -> list[str]:
    """Where pixels blur a number by more than the error that was wanted of it, which no pass can mend."""
    worst = [(target, target.largest_of_pixels(done.errors)) for target in criteria.targets]
    return [
        f"warning: the pixels of this image blur {number.observation} ({number.metric}) by up to"
        f" {number.pixel_error:.2g} beside that, more than {target}; a larger image blurs less"
        for target, number in worst
        if number is not None and number.pixel_error > target.error
    ]


def say_how_it_ended(done: Finished, code: int) -> None:
    """On stderr: how far it came, and how to go on where it did not come far enough."""
    resume = shlex.join(["vitrail", *sys.argv[1:], *([] if "--resume" in sys.argv else ["--resume"])])
    if done.record is None:
        typer.echo("interrupted before the first pass was done; nothing was written", err=True)
        return
    passes = done.record["passes"]
    typer.echo(f"{passes['count']} passes, {sum(passes['cpu_s']):.2g} CPU s", err=True)
    if code == ExitCode.INTERRUPTED:
        typer.echo(f"interrupted: the image holds the finished passes; to go on: {resume}", err=True)
    elif code == ExitCode.INCONCLUSIVE:
        typer.echo(f"the error is larger than wanted; to go on, with more passes or seconds: {resume}", err=True)
