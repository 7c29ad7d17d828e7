"""The program ``vitrail``: one verb a file, loaded when it is called."""

from __future__ import annotations

import signal
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

import typer
from typer.core import TyperGroup

VERBS = {
    "check": "Say what is wrong with a scene, each error with its place and remedy.",
    "plan": "Say what a scene requires, phenomenon by phenomenon, why, and what it costs.",
    "explain": "Print the certificate: what POV-Ray cannot express exactly, and by how much.",
    "emit": "Write the input of one engine into a folder.",
    "render": "Render a scene with one engine.",
    "trace": "Follow one ray through a scene and print its vertices.",
    "compare": "Render scenes in both engines, judge the differences, write a report.",
    "score": "Judge two images of a scene from any renderer.",
    "tradeoff": "Measure speed against accuracy over the knobs of both engines.",
    "extremes": "Find out how far each invariant holds in both engines.",
    "mutants": "Inject known defects and show which of them the verdicts catch.",
    "agreement": "Make one table of what the engines agree on, and how far, from finished comparisons.",
    "report": "Write the report of a finished comparison again.",
    "bless": "Accept images as the reference of a scene, with a reason.",
    "doctor": "Say what is installed, what is missing, and what to do.",
}
"""Verb to its line in the help. The function of the same name lives in the file of the same name beside this one."""

FOLDER = Path(__file__).parent


def load_verb(name: str) -> Any:
    """The command of one verb, from its file."""
    return _command(name, getattr(import_module(f"vitrail.commands.{name}"), name))


def _command(name: str, function: Callable[..., Any]) -> Any:
    verb = typer.Typer(add_completion=False)
    verb.command(name, help=VERBS[name])(function)
    command = typer.main.get_command(verb)
    command.name = name
    return command


def _nothing() -> None:
    """Stands for a verb in the help, so that the verb itself need not be loaded."""


class Verbs(Mapping[str, Any]):
    """All verbs by name, each loaded when it is asked for; one without a file does not exist."""

    def __getitem__(self, name: str) -> Any:
        if name not in set(self):
            raise KeyError(name)
        return load_verb(name)

    def __iter__(self) -> Iterator[str]:
        return (name for name in VERBS if (FOLDER / f"{name}.py").is_file())

    def __len__(self) -> int:
        return len(list(iter(self)))


class VerbGroup(TyperGroup):
    """A group that shows its help without loading a single verb."""

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self.commands = Verbs()  # type: ignore[assignment]

    def list_commands(self, ctx: Any) -> list[str]:
        return list(self.commands)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """A stub with the help line; ``resolve_command`` loads what is really called."""
        return _command(cmd_name, _nothing) if cmd_name in set(self.commands) else None

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        name, stub, rest = super().resolve_command(ctx, args)
        return name, load_verb(name) if stub is not None and name is not None else None, rest


app = typer.Typer(
    cls=VerbGroup,
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Render one glass scene in two engines and say, phenomenon by phenomenon, where they agree.",
)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        typer.echo(f"vitrail {version('vitrail')}")
        raise typer.Exit


@app.callback()
def vitrail(
    version: bool = typer.Option(False, "--version", callback=_print_version, is_eager=True, help="Print the version."),
) -> None:
    """Render one glass scene in two engines and say, phenomenon by phenomenon, where they agree."""


def main() -> None:
    """Run the program; Ctrl-C ends it with 130, as shells expect, and SIGTERM with 143, its engines with it.

    A defect of the program itself ends with 70 and its traceback, and is never taken for a verdict.
    """
    from vitrail.commands.exit_code import DEFECT, INTERRUPTED, TERMINATED

    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(TERMINATED))
    try:
        app()
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    except Exception:
        traceback.print_exc()
        sys.exit(DEFECT)


if __name__ == "__main__":
    main()
