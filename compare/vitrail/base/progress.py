"""How far long work is: the one way in which engines, scenes, passes and studies say it."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[str, float, float], None]
"""Called with the phase, the work done and the work in all, as often as the work likes."""


def silent(phase: str, done: float, total: float) -> None:
    """Progress that nobody watches."""


def named(progress: Progress, name: str) -> Progress:
    """The progress of one part among several: its phases carry its name."""
    return lambda phase, done, total: progress(f"{name}: {phase}", done, total)
