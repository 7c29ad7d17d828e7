"""A study remembers every finished task, whatever moment it is killed at."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from vitrail.pipeline.campaign import Campaign, run_campaign
from vitrail.pipeline.task import Task
from vitrail.pipeline.task_log import TaskLog, read_rows

pytestmark = pytest.mark.slow

STUDY = """
import sys, time
from pathlib import Path
from vitrail.pipeline.campaign import Campaign, run_campaign
from vitrail.pipeline.task import Task

def square(spec):
    time.sleep(0.03)
    if spec["x"] == 13:
        raise ValueError("thirteen is refused")
    return {"square": spec["x"] ** 2}, {"cpu_s": time.process_time()}

tasks = [Task("square", {"x": x}) for x in range(40)]
run_campaign(Campaign(tasks, {"square": square}), Path(sys.argv[1]), jobs=2)
"""


def _start(out: Path) -> subprocess.Popen:
    return subprocess.Popen([sys.executable, "-c", STUDY, str(out)])


def test_killed_ten_times_gives_the_same_files(tmp_path: Path) -> None:
    once, often = tmp_path / "once", tmp_path / "often"
    assert _start(once).wait() == 0
    # Kill at random moments; the budget of 10 kills is the issue's, the moments are not fixed on purpose.
    for _ in range(10):
        process = _start(often)
        time.sleep(random.uniform(0.3, 1.0))
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
    assert _start(often).wait() == 0
    assert (once / "samples.jsonl.gz").read_bytes() == (often / "samples.jsonl.gz").read_bytes()
    assert [row.key for row in read_rows(once)] == [row.key for row in read_rows(often)]


def test_a_failing_task_is_a_row_with_its_words(tmp_path: Path) -> None:
    assert _start(tmp_path).wait() == 0
    failed = [row for row in read_rows(tmp_path) if row.failure]
    assert [row.failure for row in failed] == ["ValueError: thirteen is refused"]


@pytest.mark.parametrize("torn", [b"", b'{"result": "{', b'{"result": 1}\n', b"\xff\xfe garbage"])
def test_a_torn_last_line_is_dropped(tmp_path: Path, torn: bytes) -> None:
    tasks = [Task("double", {"x": x}) for x in range(3)]
    run_campaign(Campaign(tasks, {"double": lambda spec: ({"y": 2 * spec["x"]}, {})}), tmp_path)
    log = TaskLog(tmp_path)
    whole = log.journal.read_bytes()
    log.journal.write_bytes(whole + torn)
    again = TaskLog(tmp_path)
    assert again.missing(tasks) == []
    assert log.journal.read_bytes() == whole


def test_progress_counts_and_finished_tasks_are_not_run_again(tmp_path: Path) -> None:
    calls: list[int] = []
    seen: list[tuple[str, float, float]] = []

    def work(spec):
        calls.append(spec["x"])
        return {"y": spec["x"]}, {"cpu_s": 1.0}

    tasks = [Task("work", {"x": x}) for x in (1, 2, 2, 3)]
    run_campaign(Campaign(tasks[:2], {"work": work}), tmp_path)
    rows = run_campaign(Campaign(tasks, {"work": work}), tmp_path, progress=lambda *step: seen.append(step))
    assert calls == [1, 2, 3]
    assert [row.result for row in rows] == [{"y": 1}, {"y": 2}, {"y": 3}]
    assert seen == [("tasks", 3, 3)]
