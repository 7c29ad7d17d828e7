"""Do pieces of work, some at a time: the scenes of a comparison, the tasks of a study.

The work starts engines as processes of their own, so threads are enough to keep several of them busy.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from itertools import islice
from typing import TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")


def run_each(
    items: Iterable[Item],
    work: Callable[[Item], Result],
    keep: Callable[[Item, Result], None],
    *,
    jobs: int = 1,
) -> None:
    """Do ``work`` for every item, ``jobs`` at a time, and ``keep`` each item with its result as it finishes.

    A result depends on its item alone, so that neither ``jobs`` nor the order matters. ``keep`` is called in this
    thread, once at a time. What ``work`` or ``keep`` raises ends everything, after what is under way.

    Python hears Ctrl-C in its main thread only. A single job runs in this thread, where its engine hears it at once.
    Several jobs run in threads of their own: their engines are stopped, and what has finished is kept.
    """
    if jobs == 1:
        for item in items:
            keep(item, work(item))
        return
    waiting = iter(items)
    under_way: dict[Future[Result], Item] = {}
    with ThreadPoolExecutor(jobs) as pool:
        try:
            while True:
                # Start no more than fits, so that an interrupt has little to wait for.
                for item in islice(waiting, jobs - len(under_way)):
                    under_way[pool.submit(work, item)] = item
                if not under_way:
                    return
                for future in wait(under_way, return_when=FIRST_COMPLETED).done:
                    keep(under_way.pop(future), future.result())
        except KeyboardInterrupt:
            wait(under_way)
            for future, item in under_way.items():
                if not isinstance(future.exception(), KeyboardInterrupt):
                    keep(item, future.result())
            raise
