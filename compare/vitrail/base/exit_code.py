"""How the programs of Vitrail end: the one table of their exit codes.

The tracer's own are the same numbers, but for 1: it judges nothing, and ends with 1 where it cannot write or meets a
limit.
"""

from __future__ import annotations

from enum import IntEnum


class ExitCode(IntEnum):
    """What a caller learns without reading a word."""

    AGREES = 0
    """Or: done, where nothing was judged."""
    DEVIATES = 1
    SCENE_ERROR = 2
    """A wrong scene, option or reference, or a file that cannot be read or written."""
    NOT_TRANSLATABLE = 3
    ENGINE_FAILED = 4
    INCONCLUSIVE = 5
    DEFECT = 70
    """A defect of this program, as in sysexits.h. Python would end with 1, which says that a scene deviates."""
    HUNG_UP = 129
    """SIGHUP: the terminal was closed. 128 and the number of the signal, as shells expect; so are those below."""
    INTERRUPTED = 130
    """Ctrl-C."""
    QUIT = 131
    """SIGQUIT."""
    TERMINATED = 143
    """SIGTERM."""
