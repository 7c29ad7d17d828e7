"""What of the parts that Vitrail works with is installed here, and in which version.

Every part answers for itself: a program is asked for its version, a Python package for its metadata. Nothing here
raises because something is missing; it is said, with what to do.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from dataclasses import asdict, dataclass
from importlib import metadata
from typing import Any

from vitrail.engines.base import EngineFailure
from vitrail.engines.isolate import walls_here
from vitrail.engines.povray import Povray
from vitrail.engines.tracer import Tracer

OLDEST_PYTHON = (3, 11)
SETUP = "run `make setup`"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")


@dataclass(frozen=True)
class Finding:
    """One part. ``to_do`` is empty where nothing is to do; ``is_needed`` means that comparing fails without it."""

    part: str
    purpose: str
    is_there: bool
    is_needed: bool
    version: str = ""
    place: str = ""
    to_do: str = ""

    def as_record(self) -> dict[str, Any]:
        return asdict(self)


def findings() -> list[Finding]:
    """Every part, engines first."""
    return [_tracer(), _povray(), _python(), *map(_package, _required_packages()), _browser(), _isolation(), _cores()]


def _tracer() -> Finding:
    part, purpose = "vitrail-tracer", "renders scenes"
    tracer = Tracer()
    try:
        return Finding(part, purpose, True, True, tracer.version(), str(tracer.program))
    except EngineFailure as failure:
        return Finding(part, purpose, False, True, to_do=f"{failure.what}; {failure.remedy}")


def _povray() -> Finding:
    part, purpose = "POV-Ray", "renders scenes for comparison"
    povray = Povray()
    try:
        return Finding(part, purpose, True, True, povray.version(), str(povray.program))
    except EngineFailure as failure:
        return Finding(part, purpose, False, True, to_do=f"{failure.what}; {failure.remedy}")


def _python() -> Finding:
    version = ".".join(map(str, sys.version_info[:3]))
    is_new_enough = sys.version_info >= OLDEST_PYTHON
    to_do = "" if is_new_enough else "install Python 3.11 or newer"
    return Finding("Python", "runs everything but the engines", is_new_enough, True, version, sys.executable, to_do)


def _required_packages() -> list[str]:
    """The packages that our own metadata asks for, without extras; none where we run uninstalled."""
    try:
        wanted = metadata.requires("vitrail") or []
    except metadata.PackageNotFoundError:
        return []
    return sorted(re.split(r"[\s<>=!~;\[]", line, maxsplit=1)[0] for line in wanted if "extra ==" not in line)


def _package(name: str) -> Finding:
    purpose = "Python package"
    try:
        return Finding(name, purpose, True, True, metadata.version(name))
    except metadata.PackageNotFoundError:
        return Finding(name, purpose, False, True, to_do=SETUP)


def _browser() -> Finding:
    """Only the tests of the report need a browser."""
    part, purpose = "Chromium", "looks at the report in the tests"
    place = next((found for name in BROWSERS if (found := shutil.which(name))), None)
    if place is None:
        return Finding(part, purpose, False, False, to_do="for the tests: `apt-get install chromium`")
    try:
        said = subprocess.run([place, "--version"], capture_output=True, text=True, timeout=30, check=False).stdout
    except (OSError, subprocess.TimeoutExpired) as error:
        return Finding(part, purpose, False, False, place=place, to_do=f"it does not start: {error}")
    return Finding(part, purpose, True, False, said.strip(), place)


def _isolation() -> Finding:
    """POV-Ray's own file restrictions do nothing, so the walls around it matter [P 8.4]."""
    walls = walls_here(shutil.which("povray") or "/bin/true")
    to_do = "" if walls.is_complete else "for full isolation: util-linux with user namespaces, or run as root"
    return Finding("isolation", "keeps POV-Ray apart", walls.is_complete, False, "; ".join(walls.words), to_do=to_do)


def _cores() -> Finding:
    return Finding("processor", "renders", True, False, f"{len(os.sched_getaffinity(0))} cores to use")
