"""How an error reaches the user: its message on stderr, and the exit code that says what kind it was."""

from __future__ import annotations

import errno
from collections.abc import Iterator
from contextlib import contextmanager

import typer

from vitrail.base.fault import Fault

AGREES, DEVIATES, SCENE_ERROR, NOT_TRANSLATABLE, ENGINE_FAILED, INCONCLUSIVE = range(6)
INTERRUPTED, TERMINATED = 130, 143
DEFECT = 70
"""A defect of this program, as in sysexits.h. Python would end with 1, which says that a scene deviates."""
DISK_FULL = (errno.ENOSPC, errno.EDQUOT)


@contextmanager
def exit_codes() -> Iterator[None]:
    """Turn the errors that a user can cause or meet into a message and an exit code.

    A wrong scene, option or image, or a file that cannot be read or written, ends with 2, a scene that POV-Ray cannot
    express with 3, an engine that failed with 4, Ctrl-C with 130. Any other exception is a defect of this program and
    keeps its traceback.
    """
    from vitrail.engines.base import EngineFailure
    from vitrail.scene.diagnostic import SceneErrors

    try:
        yield
    except SceneErrors as errors:
        _say(str(diagnostic) for diagnostic in errors.diagnostics)
        raise typer.Exit(SCENE_ERROR) from None
    except EngineFailure as failure:
        _say([str(failure)])
        raise typer.Exit(ENGINE_FAILED) from None
    except KeyboardInterrupt:
        _say(["interrupted"])
        raise typer.Exit(INTERRUPTED) from None
    except OSError as error:
        # Writing to a full disk names no file, and is nobody's defect.
        if error.filename is None and error.errno not in DISK_FULL:
            raise
        what = (error.strerror or "it cannot be used").lower()
        _say([f"{error.filename or 'the disk'}: {what}; name another place, or free this one"])
        raise typer.Exit(SCENE_ERROR) from None
    except Exception as error:
        from vitrail.lower.povray import NotTranslatable

        if isinstance(error, Fault):
            _say([str(error)])
            raise typer.Exit(SCENE_ERROR) from None
        if not isinstance(error, NotTranslatable):
            raise
        _say(str(diagnostic) for diagnostic in error.diagnostics)
        raise typer.Exit(NOT_TRANSLATABLE) from None


def usage_error(message: str) -> typer.Exit:
    """A wrong option, said on stderr; raise what comes back."""
    _say([message])
    return typer.Exit(SCENE_ERROR)


def _say(lines: Iterator[str] | list[str]) -> None:
    for line in lines:
        typer.echo(line, err=True)
