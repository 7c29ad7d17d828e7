"""Walls around a foreign program: fresh environment, limits on time, memory and files, no network, no rights.

POV-Ray's own file restrictions do nothing [P 8.4], so the walls are built outside, of whatever the machine has: network
namespaces, a user without rights, resource limits, an end with ours. What could not be had is said, run by run.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

NOBODY = 65534
"""User and group without rights, on every Debian."""


@dataclass(frozen=True)
class Allowance:
    """What an isolated program may use."""

    cpu_s: int = 36_000
    memory_bytes: int = 8 << 30
    file_bytes: int = 4 << 30


@dataclass(frozen=True)
class Isolated:
    """A command that runs inside the walls, and the walls in words."""

    command: tuple[str, ...]
    walls: tuple[str, ...]


def isolate(program: Path, arguments: Sequence[str], folder: Path, allowance: Allowance) -> Isolated:
    """The command that runs ``program`` in ``folder``, which becomes its home and the only place it may write.

    The folder and what is in it are handed to the user the program will run as.
    """
    around = walls_here(str(program))
    if os.geteuid() == 0 and "setpriv" in around.wrapper:
        for path in (folder, *folder.rglob("*")):
            os.chown(path, NOBODY, NOBODY)
    clean = ["env", "-i", "-C", str(folder), f"HOME={folder}", f"TMPDIR={folder}", f"PATH={os.defpath}", "LC_ALL=C"]
    limits = [
        "prlimit",
        f"--cpu={allowance.cpu_s}",
        f"--as={allowance.memory_bytes}",
        f"--fsize={allowance.file_bytes}",
        "--core=0",
    ]
    return Isolated((*clean, *limits, *around.wrapper, str(program), *arguments), around.words)


@dataclass(frozen=True)
class Walls:
    """The commands that go before a program, what they do in words, and whether nothing is missing."""

    wrapper: tuple[str, ...]
    words: tuple[str, ...]
    is_complete: bool


@cache
def walls_here(program: str) -> Walls:
    """The walls that this machine allows around ``program``."""
    is_root = os.geteuid() == 0
    words = ["private home and environment", "limits on processor time, memory and file size"]
    wrapper: list[str] = []
    # Shut off the network and shared memory.
    network = (
        ["unshare", "--net", "--ipc"] if is_root else ["unshare", "--user", "--map-current-user", "--net", "--ipc"]
    )
    has_network_wall = _works([*network, "true"])
    if has_network_wall:
        wrapper += network
        words.append("no network")
    else:
        words.append("network not shut off: no namespaces here")
    # Become nobody, where nobody can reach the program.
    user = ["setpriv", "--no-new-privs", "--pdeathsig=KILL"]
    if is_root:
        user += [f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"]
    has_user_wall = _works([*wrapper, *user, "test", "-x", program])
    if has_user_wall:
        wrapper += user
        words.append("user without rights" if is_root else "no new rights")
    elif is_root:
        words.append("runs as root: no setpriv, or the program cannot be reached by others")
    else:
        words.append("runs with the caller's rights")
    return Walls(tuple(wrapper), tuple(words), has_network_wall and has_user_wall)


def _works(command: Sequence[str]) -> bool:
    if shutil.which(command[0]) is None:
        return False
    return subprocess.run(command, capture_output=True, check=False).returncode == 0
