"""Where a run is made, with what."""

from __future__ import annotations

import os
import platform
import sys
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from vitrail.judge.records import Run


def about_run(command: tuple[str, ...], threads: int = 0) -> Run:
    """The record of a run that begins now; ``threads`` 0 takes every core."""
    try:
        own = version("vitrail")
    except PackageNotFoundError:
        own = "unpacked"
    return Run(
        command=command,
        started=datetime.now(UTC).strftime("%Y-%m-%d %H:%M:%S UTC"),
        vitrail_version=own,
        python=sys.version.split()[0],
        platform=platform.platform(terse=True),
        processor=_processor(),
        threads=threads or os.cpu_count(),
    )


def _processor() -> str:
    """The name the machine gives its processor, or nothing."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "")
