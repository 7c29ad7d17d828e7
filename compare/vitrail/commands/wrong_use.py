"""A wrong word on the command line, said as every other error is: ``what was typed: what is wrong; remedy``."""

from __future__ import annotations

from typing import Any

import typer
from typer.core import TyperCommand
from typer.exceptions import TyperException

from vitrail.base.suggestion import nearest
from vitrail.commands.errors import usage_error


class Verb(TyperCommand):
    """A verb whose wrong options and arguments are told by ``wrong_use``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        try:
            return super().parse_args(ctx, args)
        except TyperException as error:
            raise wrong_use(error, ctx.command_path) from None


def wrong_use(error: TyperException, verb: str) -> typer.Exit:
    """The message of the parser's complaint about ``verb``, on stderr; raise what comes back.

    The parser's own sentence names the option but not the value, and calls the kinds by their names in Python.
    """
    look_up = f"`{verb} --help` says what it takes"
    parameter, option = getattr(error, "param", None), getattr(error, "option_name", None)
    if parameter is not None and error.__cause__ is not None:
        return usage_error(_wrong_value(parameter, error.__cause__))
    if parameter is not None:
        what = f"is not as it should be ({error.message.rstrip('.')})" if error.message else "is missing"
        return usage_error(f"{_name(parameter)}: {what}; {look_up}")
    if option is not None and hasattr(error, "possibilities"):
        similar = error.possibilities
        return usage_error(
            f"{option}: there is no such option; {f'did you mean `{similar[0]}`?' if similar else look_up}"
        )
    if option is not None:
        return usage_error(f"{option}: has no value; write one after it")
    message = error.format_message().rstrip(".")
    return usage_error(f"{verb}: {message[:1].lower()}{message[1:]}; {look_up}")


def _wrong_value(parameter: Any, cause: Any) -> str:
    """What was typed for a parameter, what is wrong with it, and what its kind takes."""
    error = cause.errors(include_url=False)[0]
    typed = f"{_name(parameter)} {error['input']}"
    if (choices := parameter.type_descriptor.choices) is not None:
        names = [str(choice) for choice in choices]
        close = nearest(str(error["input"]), names)
        remedy = f"did you mean `{close}`?" if close else "choose one of them"
        return f"{typed}: is not one of {', '.join(names)}; {remedy}"
    if error["type"] == "greater_than_equal":
        return f"{typed}: is below {parameter.min:g}; write {parameter.min:g} or more"
    return f"{typed}: is not a {'whole number' if error['type'].startswith('int') else 'number'}; write one"


def _name(parameter: Any) -> str:
    """An option as it is typed, an argument as the help writes it."""
    if parameter.param_type_name == "option":
        return str(max(parameter.opts, key=len))
    return str(parameter.metavar or parameter.name.upper()).removesuffix("...")
