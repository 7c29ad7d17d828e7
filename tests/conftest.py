"""What holds for every test: its tier, properties without a clock, and a Ctrl-C that can be sent."""

from __future__ import annotations

import signal
import sys
from collections.abc import Iterator

import pytest
from hypothesis import settings

from tests import tiers

# A busy machine must not fail a property.
settings.register_profile("vitrail", deadline=None)
settings.load_profile("vitrail")

# A shell starts a background job with Ctrl-C ignored, and its children inherit that: tests that send it would wait.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

sys.addaudithook(tiers.guard)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    tiers.mark_fast(items)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    tiers.running[:] = [item]
    try:
        return (yield)
    finally:
        tiers.running.clear()
