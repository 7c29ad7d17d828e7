"""``--target-error PHENOMENON=ERROR``, as the verbs that have it read it."""

from __future__ import annotations

from collections.abc import Iterable

from vitrail.commands.errors import usage_error


def parse_target_error(text: str, known: Iterable[str], who: str, remedy: str) -> tuple[str, str, float]:
    """Phenomenon, metric (empty where none is named) and error of ``caustic=0.01`` or ``caustic.r50=0.01``.

    ``known`` are the phenomena there are, ``who`` has them, for the message. Raises typer.Exit.
    """
    name, _, error = text.partition("=")
    phenomenon, _, metric = name.partition(".")
    phenomena = list(dict.fromkeys(known))
    if phenomenon not in phenomena:
        raise usage_error(f"--target-error {text}: {who} {', '.join(phenomena) or 'nothing'}; {remedy}")
    try:
        wanted = float(error)
    except ValueError:
        wanted = 0.0
    if not 0 < wanted < 1:
        raise usage_error(f"--target-error {text}: write a share above 0 and below 1, such as {name}=0.01")
    return phenomenon, metric, wanted
