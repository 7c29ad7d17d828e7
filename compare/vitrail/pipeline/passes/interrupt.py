"""Ctrl-C while passes are made: the first finishes the pass at hand, the second abandons it; neither loses a pass."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
from collections.abc import Iterator
from types import FrameType

FINISHING = "\nfinishing the pass at hand; Ctrl-C again abandons it\n"


class Interrupt:
    """Whether somebody asked to stop. ``abandonable`` surrounds the only work that may be cut off anywhere."""

    def __init__(self) -> None:
        self.asked = False
        self._abandonable = False

    @contextlib.contextmanager
    def abandonable(self) -> Iterator[None]:
        """Within it a second Ctrl-C raises KeyboardInterrupt."""
        self._abandonable = True
        try:
            yield
        finally:
            self._abandonable = False

    def hear(self, number: int, frame: FrameType | None) -> None:
        again, self.asked = self.asked, True
        if again and self._abandonable:
            raise KeyboardInterrupt
        if not again:
            # Not by print: the signal may have come in the middle of one.
            os.write(2, FINISHING.encode())


@contextlib.contextmanager
def patient_interrupt() -> Iterator[Interrupt]:
    """Hear Ctrl-C in this way, in the main thread; elsewhere nobody can press it."""
    interrupt = Interrupt()
    if threading.current_thread() is not threading.main_thread():
        yield interrupt
        return
    before = signal.signal(signal.SIGINT, interrupt.hear)
    try:
        yield interrupt
    finally:
        signal.signal(signal.SIGINT, before)
