"""One word for everybody: stop. Python tells its main thread alone of a signal; the others look here."""

from __future__ import annotations

import threading

_stop = threading.Event()


def stop_threads() -> None:
    """Ask all threads but the main one to end what they run."""
    _stop.set()


def must_stop() -> bool:
    """Whether this thread shall end what it runs. The main thread is told by an exception."""
    return _stop.is_set() and threading.current_thread() is not threading.main_thread()


def forget_stop() -> None:
    """The program has ended, and whoever called it goes on."""
    _stop.clear()
