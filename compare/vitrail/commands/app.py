"""The program ``vitrail``: one verb a file, loaded when it is called."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

import typer
from typer.core import TyperCommand, TyperGroup
from typer.exceptions import TyperException

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
    from vitrail.commands.wrong_use import Verb

    return _command(name, getattr(import_module(f"vitrail.commands.{name}"), name), Verb)


def _command(name: str, function: Callable[..., Any], kind: type[TyperCommand] = TyperCommand) -> Any:
    verb = typer.Typer(add_completion=False)
    verb.command(name, cls=kind, help=VERBS[name])(function)
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
        if args and args[0] not in set(self.commands) and not ctx.resilient_parsing:
            raise _unknown_verb(args[0], list(self.commands))
        name, stub, rest = super().resolve_command(ctx, args)
        return name, load_verb(name) if stub is not None and name is not None else None, rest

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        if not args:
            return super().parse_args(ctx, args)
        try:
            return super().parse_args(ctx, args)
        except TyperException as error:
            from vitrail.commands.wrong_use import wrong_use

            raise wrong_use(error, ctx.command_path) from None


def _unknown_verb(name: str, known: list[str]) -> typer.Exit:
    from vitrail.base.suggestion import suggestion
    from vitrail.commands.errors import usage_error

    return usage_error(f"{name}: there is no such verb; {suggestion(name, known, 'verb')}")


app = typer.Typer(
    cls=VerbGroup,
    no_args_is_help=True,
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
    """Run the program; Ctrl-C ends it with 130, as shells expect, SIGTERM with 143, and its engines end with it.

    A defect of the program itself ends with 70 and its traceback, and is never taken for a verdict.
    """
    from vitrail.base.exit_code import ExitCode
    from vitrail.commands.ending import signals_minded

    try:
        with signals_minded():
            app()
    except KeyboardInterrupt:
        sys.exit(ExitCode.INTERRUPTED)
    except Exception:
        traceback.print_exc()
        sys.exit(ExitCode.DEFECT)


if __name__ == "__main__":
    main()
