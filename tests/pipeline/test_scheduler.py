"""Work is done some at a time, kept as it finishes, and nothing that was under way is lost to Ctrl-C."""

from __future__ import annotations

import threading
import time

import pytest

from vitrail.pipeline.scheduler import run_each


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_every_result_is_kept_with_its_item_in_this_thread(jobs: int) -> None:
    kept: dict[int, int] = {}
    threads = set()

    def keep(item: int, result: int) -> None:
        threads.add(threading.current_thread())
        kept[item] = result

    run_each(range(7), lambda item: item**2, keep, jobs=jobs)
    assert kept == {item: item**2 for item in range(7)}
    assert threads == {threading.main_thread()}


def test_no_more_than_the_jobs_are_under_way() -> None:
    under_way, most = [0], [0]
    lock = threading.Lock()

    def work(item: int) -> None:
        with lock:
            under_way[0] += 1
            most[0] = max(most[0], under_way[0])
        time.sleep(0.01)
        with lock:
            under_way[0] -= 1

    run_each(range(12), work, lambda item, result: None, jobs=3)
    assert most == [3]


def test_a_single_job_runs_where_ctrl_c_is_heard() -> None:
    threads: list[threading.Thread] = []
    run_each([0], lambda item: threads.append(threading.current_thread()), lambda item, result: None)
    assert threads == [threading.main_thread()]


def test_ctrl_c_keeps_what_is_under_way_and_starts_nothing_more() -> None:
    kept: list[int] = []
    second_may_end = threading.Event()

    def work(item: int) -> int:
        if item == 1:
            second_may_end.wait(10)
        return item

    def keep(item: int, result: int) -> None:
        kept.append(item)
        if item == 0:
            second_may_end.set()
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_each(range(6), work, keep, jobs=2)
    assert kept == [0, 1]


@pytest.mark.parametrize("jobs", [1, 2])
def test_what_the_work_raises_ends_everything(jobs: int) -> None:
    def work(item: int) -> int:
        if item == 2:
            raise ZeroDivisionError
        return item

    kept: list[int] = []
    with pytest.raises(ZeroDivisionError):
        run_each(range(9), work, lambda item, result: kept.append(item), jobs=jobs)
    assert set(kept) <= {0, 1, 3}
