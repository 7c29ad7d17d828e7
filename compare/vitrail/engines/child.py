"""Run one program apart from us: in its own process group, within limits, listened to, and measured."""

from __future__ import annotations

import contextlib
import os
import resource
import selectors
import signal
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from vitrail.base.stopping import must_stop

KEPT_LINES = 200
"""How many of the last lines that a program said are kept for a message."""

GIBIBYTE = 1 << 30

GLANCE_S = 0.02
"""How often the clock and the memory are looked at while a program says nothing."""


@dataclass(frozen=True)
class Limits:
    """What a program may use. ``memory_bytes`` limits its address space; None leaves a limit out."""

    memory_bytes: int | None = None
    wall_s: float | None = None


@dataclass(frozen=True)
class Finished:
    """How a program ended. ``said`` are its last lines on stderr; a negative ``code`` is the signal that ended it.

    ``peak_memory_bytes`` is the most that was resident at any look, every 20 ms; what is taken and given back between
    the last look and the end is missed.
    """

    code: int
    stdout: str
    said: str
    cpu_s: float
    wall_s: float
    peak_memory_bytes: int
    interrupted: bool
    timed_out: bool

    def ending(self) -> str:
        """How it ended, in words."""
        if self.timed_out:
            return f"was stopped after {self.wall_s:.0f} s"
        if self.code < 0:
            return f"was ended by {signal.Signals(-self.code).name}"
        return f"ended with exit code {self.code}"


def run_child(
    command: Sequence[str | Path],
    *,
    limits: Limits = Limits(),
    on_line: Callable[[str], bool] | None = None,
    stop: threading.Event | None = None,
) -> Finished:
    """Run a program to its end.

    ``on_line`` is given every line of its stderr and answers whether it has used it up; the others are kept. Ctrl-C is
    passed on to the program once, so that it may write what is finished, and ends it the second time. Python hears it
    in its main thread only; a program that is run from another is ended by setting ``stop``. Nothing of the program
    survives this function. Raises OSError when it cannot be started, and KeyboardInterrupt when all shall stop.
    """
    if must_stop():
        raise KeyboardInterrupt
    started = time.monotonic()
    with tempfile.TemporaryFile() as stdout:
        process = subprocess.Popen(
            [str(part) for part in command],
            stdin=subprocess.DEVNULL,
            stdout=stdout,
            stderr=subprocess.PIPE,
            start_new_session=True,
        )
        listener = _Listener(process, started, limits, on_line, stop)
        try:
            _limit(process.pid, limits)
            listener.listen()
            listener.wait()
        finally:
            # Leave nothing of the group running; until it is collected, an ended program keeps its number.
            _kill_group(process)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        stdout.seek(0)
        return Finished(
            code=process.returncode,
            stdout=stdout.read().decode(errors="replace"),
            said="\n".join(listener.kept[-KEPT_LINES:]),
            cpu_s=usage.ru_utime + usage.ru_stime,
            wall_s=time.monotonic() - started,
            peak_memory_bytes=listener.peak_memory_bytes or usage.ru_maxrss * 1024,
            interrupted=listener.interrupted,
            timed_out=listener.timed_out,
        )


class _Listener:
    """Reads a program's stderr line by line until it closes it, minding Ctrl-C and the clock."""

    def __init__(
        self,
        process: subprocess.Popen[bytes],
        started: float,
        limits: Limits,
        on_line: Callable[[str], bool] | None,
        stop: threading.Event | None,
    ) -> None:
        self.process, self.started, self.limits, self.on_line, self.stop = process, started, limits, on_line, stop
        self.kept: list[str] = []
        self.interrupted = self.timed_out = False
        self.rest = b""
        self.peak_memory_bytes = 0

    def listen(self) -> None:
        assert self.process.stderr is not None
        with self.process.stderr as stream, selectors.DefaultSelector() as selector:
            selector.register(stream, selectors.EVENT_READ)
            while True:
                try:
                    if not self._read(stream, selector):
                        break
                except KeyboardInterrupt:
                    self._pass_on()
        self._take(self.rest)

    def wait(self) -> None:
        """Wait for the end of a program that has closed its stderr, without collecting it."""
        while os.waitid(os.P_PID, self.process.pid, os.WEXITED | os.WNOWAIT | os.WNOHANG) is None:
            self._mind_the_limits()
            try:
                time.sleep(0.005)
            except KeyboardInterrupt:
                self._pass_on()

    def _read(self, stream: IO[bytes], selector: selectors.BaseSelector) -> bool:
        """One piece of output; False at its end, or when the time is up."""
        self._mind_the_limits()
        if not selector.select(GLANCE_S):
            return True
        piece = os.read(stream.fileno(), 1 << 16)
        *lines, self.rest = (self.rest + piece).replace(b"\r", b"\n").split(b"\n")
        for line in lines:
            self._take(line)
        return bool(piece)

    def _take(self, line: bytes) -> None:
        text = line.decode(errors="replace").rstrip()
        if text and not (self.on_line is not None and self.on_line(text)):
            self.kept.append(text)

    def _mind_the_limits(self) -> None:
        """End the program when its time is up or somebody wants it to stop; see how much memory it has taken."""
        self.peak_memory_bytes = max(self.peak_memory_bytes, _resident_peak_bytes(self.process.pid))
        if self.limits.wall_s is not None and time.monotonic() - self.started > self.limits.wall_s:
            self.timed_out = True
        stopped = must_stop() or (self.stop is not None and self.stop.is_set())
        self.interrupted |= stopped
        if self.timed_out or stopped or (self.stop is not None and self.interrupted):
            os.killpg(self.process.pid, signal.SIGKILL)

    def _pass_on(self) -> None:
        """The first Ctrl-C asks the program to finish, the second ends it."""
        os.killpg(self.process.pid, signal.SIGKILL if self.interrupted else signal.SIGINT)
        self.interrupted = True


def _limit(pid: int, limits: Limits) -> None:
    """Set the limits of a program that runs already: no core file, no more memory than allowed."""
    try:
        resource.prlimit(pid, resource.RLIMIT_CORE, (0, 0))
        if limits.memory_bytes is not None:
            resource.prlimit(pid, resource.RLIMIT_AS, (limits.memory_bytes, limits.memory_bytes))
    except ProcessLookupError:
        pass  # It has ended already.
    except PermissionError:
        pass  # It has become a user of its own behind the walls of ``isolate``, which set its limits.


def _resident_peak_bytes(pid: int) -> int:
    """The most memory a running program has had resident so far; 0 when it has ended.

    The system's own count at the end (ru_maxrss) includes what *we* had resident when we started the program.
    """
    try:
        status = Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return 0
    found = [line.split()[1] for line in status.splitlines() if line.startswith("VmHWM:")]
    return int(found[0]) * 1024 if found else 0


def _kill_group(process: subprocess.Popen[bytes]) -> None:
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)
