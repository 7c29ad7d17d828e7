"""How an error reaches the user: its message on stderr, and the exit code that says what kind it was."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import typer

from vitrail.base.disk_error import is_disk_error, words_of
from vitrail.base.exit_code import ExitCode
from vitrail.base.fault import Fault


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
        raise typer.Exit(ExitCode.SCENE_ERROR) from None
    except EngineFailure as failure:
        _say([str(failure)])
        raise typer.Exit(ExitCode.ENGINE_FAILED) from None
    except KeyboardInterrupt:
        _say(["interrupted"])
        raise typer.Exit(ExitCode.INTERRUPTED) from None
    except OSError as error:
        if not is_disk_error(error):
            raise
        _say([f"{words_of(error)}; name another place, or free this one"])
        raise typer.Exit(ExitCode.SCENE_ERROR) from None
    except Exception as error:
        from vitrail.lower.povray import NotTranslatable

        if isinstance(error, Fault):
            _say([str(error)])
            raise typer.Exit(ExitCode.SCENE_ERROR) from None
        if not isinstance(error, NotTranslatable):
            raise
        _say(str(diagnostic) for diagnostic in error.diagnostics)
        raise typer.Exit(ExitCode.NOT_TRANSLATABLE) from None


def usage_error(message: str) -> typer.Exit:
    """A wrong option, said on stderr; raise what comes back."""
    _say([message])
    return typer.Exit(ExitCode.SCENE_ERROR)


def _say(lines: Iterator[str] | list[str]) -> None:
    for line in lines:
        typer.echo(line, err=True)
