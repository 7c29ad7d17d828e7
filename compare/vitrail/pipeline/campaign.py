"""A campaign: a list of pure tasks, run some at a time, remembered one by one, resumed from what is there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from vitrail.base.progress import Progress, silent
from vitrail.base.record import JsonObject
from vitrail.pipeline.scheduler import run_each
from vitrail.pipeline.task import Row, Task
from vitrail.pipeline.task_log import TaskLog

Work = Callable[[JsonObject], tuple[JsonObject, JsonObject]]
"""Takes a task's spec, returns (result, cost); raises with a message for a person if it cannot."""


@dataclass(frozen=True)
class Campaign:
    """Tasks, and what does the work of each kind. A task's result depends on its spec alone, wherever it is run."""

    tasks: Sequence[Task]
    work: Mapping[str, Work]

    def row(self, task: Task) -> Row:
        """Run one task; whatever it raises becomes its row, because one bad task must not end the campaign."""
        try:
            result, cost = self.work[task.kind](task.spec)
        except Exception as error:  # noqa: BLE001 - every failure of a task is a finding of the study
            return Row(task.key, task.kind, task.spec, failure=f"{type(error).__name__}: {error}")
        return Row(task.key, task.kind, task.spec, result=result, cost=cost)


def run_campaign(campaign: Campaign, out: Path, *, jobs: int = 1, progress: Progress = silent) -> list[Row]:
    """Run the tasks that have no row in ``out`` yet; returns all rows in the order of the tasks.

    ``progress`` counts tasks. After KeyboardInterrupt nothing that was finished is lost.
    """
    log = TaskLog(out)
    missing, total = log.missing(campaign.tasks), len({task.key for task in campaign.tasks})
    done = count(total - len(missing) + 1)

    def keep(task: Task, row: Row) -> None:
        log.append(row)
        progress("tasks", next(done), total)

    run_each(missing, campaign.row, keep, jobs=jobs)
    return log.finish(campaign.tasks)
