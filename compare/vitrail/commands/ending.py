"""Signals that end the program: engines are stopped, scratch folders removed, and one line says what became of it.

Ctrl-C asks for an orderly end and may be said twice. SIGTERM, SIGHUP (a closed terminal) and SIGQUIT are an order, and
are obeyed once: what is then cleaned up is not disturbed by another. A signal that the caller ignores, as ``nohup``
does with SIGHUP, stays ignored.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from vitrail.base.exit_code import ExitCode
from vitrail.base.stopping import forget_stop, stop_threads

ORDERS = {
    signal.SIGTERM: ExitCode.TERMINATED,
    signal.SIGHUP: ExitCode.HUNG_UP,
    signal.SIGQUIT: ExitCode.QUIT,
}


@contextmanager
def signals_minded() -> Iterator[None]:
    """Mind signals in the main thread for as long as the program runs."""
    before = {number: signal.getsignal(number) for number in (*ORDERS, signal.SIGINT)}
    for number in ORDERS:
        if before[number] != signal.SIG_IGN:
            signal.signal(number, _obey)
    if before[signal.SIGINT] == signal.default_int_handler:
        signal.signal(signal.SIGINT, _interrupt)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        forget_stop()


def _obey(number: int, _frame: FrameType | None) -> None:
    for each in (*ORDERS, signal.SIGINT):
        signal.signal(each, signal.SIG_IGN)
    stop_threads()
    # Whoever prints just now may hold the lock of stderr.
    name = signal.Signals(number)
    os.write(2, f"\nended by {name.name}; finished scenes and passes are kept, run it again\n".encode())
    sys.exit(ORDERS[name])


def _interrupt(_number: int, _frame: FrameType | None) -> None:
    stop_threads()
    raise KeyboardInterrupt
