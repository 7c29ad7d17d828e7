"""Run the tasks of a study that have no row yet, some at a time; a task that fails is a row with its words.

A task's code starts the engines as processes of their own, so threads are enough to keep several of them busy.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass

from vitrail.base.record import JsonObject
from vitrail.pipeline.task import Row, Task
from vitrail.pipeline.task_log import TaskLog

Work = Callable[[JsonObject], tuple[JsonObject, JsonObject]]
"""Takes a task's spec, returns (result, cost); raises with a message for a person if it cannot."""


@dataclass(frozen=True)
class Progress:
    """How far a study is; ``remaining_s`` extrapolates from the tasks of this session (None before the first)."""

    done: int
    total: int
    remaining_s: float | None
    last: str


def run_tasks(
    tasks: Sequence[Task],
    log: TaskLog,
    work: Mapping[str, Work],
    *,
    jobs: int = 1,
    report: Callable[[Progress], None] = lambda progress: None,
) -> list[Row]:
    """Run what is missing with ``jobs`` at a time and return all rows in the order of ``tasks``.

    KeyboardInterrupt waits for the running tasks, remembers them and is raised again: nothing finished is lost.
    """
    missing = log.missing(tasks)
    total = len(dict.fromkeys(task.key for task in tasks))
    start, done_before = time.monotonic(), total - len(missing)
    pending: set[Future[Row]] = set()
    queue = iter(missing)
    with ThreadPoolExecutor(max_workers=jobs) as pool:
        try:
            while True:
                # Keep `jobs` tasks under way, no more, so that an interrupt has little to wait for.
                while len(pending) < jobs and (task := next(queue, None)) is not None:
                    pending.add(pool.submit(_attempt, task, work))
                if not pending:
                    break
                finished, pending = wait(pending, return_when=FIRST_COMPLETED)
                for future in finished:
                    log.append(future.result())
                    report(_progress(log, missing, total, done_before, start, future.result()))
        except KeyboardInterrupt:
            for future in pending:
                log.append(future.result())
            raise
    return log.finish(tasks)


def _attempt(task: Task, work: Mapping[str, Work]) -> Row:
    """Run one task; whatever it raises becomes its row, because one bad task must not end the study."""
    try:
        result, cost = work[task.kind](task.spec)
    except Exception as error:  # noqa: BLE001 - every failure of a task is a finding of the study
        return Row(task.key, task.kind, task.spec, failure=f"{type(error).__name__}: {error}")
    return Row(task.key, task.kind, task.spec, result=result, cost=cost)


def _progress(log: TaskLog, missing: list[Task], total: int, before: int, start: float, row: Row) -> Progress:
    done = sum(1 for task in missing if task.key in log.rows)
    elapsed = time.monotonic() - start
    remaining = elapsed / done * (len(missing) - done) if done else None
    return Progress(before + done, total, remaining, row.failure or row.kind)
