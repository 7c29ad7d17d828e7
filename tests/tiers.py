"""The tiers of the tests, and the guard that keeps them honest.

A test belongs to the tier ``fast`` unless its module says ``pytestmark = pytest.mark.povray`` (or ``browser``,
``tracer``, ``slow``). The guard ends a test that starts a program which its tier does not name, so that nobody has to
remember what a test needs.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

import pytest

TIERS = {
    "povray": "runs POV-Ray",
    "browser": "opens pages in Chromium",
    "tracer": "runs the built tracer",
    "slow": "starts Vitrail as a process of its own, or computes for more than two seconds",
}
"""What a test may need beyond Python, by marker, and what each means."""

running: list[pytest.Item] = []
"""The test that runs; empty between two tests."""


def mark_fast(items: Sequence[pytest.Item]) -> None:
    """Give the marker ``fast`` to every test that no other tier claims."""
    for item in items:
        if not any(item.get_closest_marker(tier) for tier in TIERS):
            item.add_marker("fast")


def needed_tier(program: object, arguments: object) -> str | None:
    """The tier that starting this program asks for; None for what every Debian machine has, such as git or bash."""
    line = [str(program), *(map(str, arguments) if isinstance(arguments, list | tuple) else [str(arguments)])]
    names = {os.path.basename(word) for word in line}
    if "povray" in names:
        return "povray"
    if names & {"chromium", "node"}:
        return "browser"
    if "vitrail-tracer" in names:
        return "tracer"
    return "slow" if names & {"vitrail", os.path.basename(sys.executable)} else None


def forbidden(item: pytest.Item, tier: str) -> bool:
    """Whether a test that carries no marker of ``tier`` may not start its programs; slow tests may start all."""
    return item.get_closest_marker(tier) is None and item.get_closest_marker("slow") is None


def guard(event: str, arguments: tuple[object, ...]) -> None:
    """An audit hook: end the test that starts a program outside its tier."""
    if event != "subprocess.Popen" or not running:
        return
    tier = needed_tier(arguments[0], arguments[1])
    if tier is not None and forbidden(running[0], tier):
        raise RuntimeError(f"{running[0].nodeid} starts {arguments[1]}; mark its module with pytest.mark.{tier}")
