"""The part of the mutants' page about ablation: where each mutant lives by it, and what it does to a clean bench."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

TEXT = """
## What ablation says, without a closed form

The scene that names a mutant was rendered again with one thing after the other switched off in both engines
([decision 20](../../decisions/0020-ablation-switches-the-scene.md)). Of {total} mutants {named} leave one suspect, the
injected phenomenon; {among} leave several, the injected one among them; {none} leave none; {wrong} leave only others.
As with the verdicts, rule and bench were made together.

Switching something off must not make a deviation of its own. Of {count} ablations of the clean bench {apart}.

| mutant | injected | suspects | goes without | stays without | unclear without |
|---|---|---|---|---|---|
"""


def ablation_text(found: Mapping[str, Any]) -> str:
    """The section in Markdown."""
    entries: Sequence[Mapping[str, Any]] = found["mutants"]
    kinds = ("named", "among", "none", "wrong")
    named, among, none, wrong = (sum(_kind(entry) == kind for entry in entries) for kind in kinds)
    clean = found["clean"]["ablated"]
    listed = "; ".join(f"{place}: {words}" for place, words in sorted(clean["apart"].items()))
    apart = f"{len(clean['apart'])} leave the engines apart or in doubt, or cannot be rendered ({listed})"
    head = TEXT.format(
        total=len(entries),
        named=named,
        among=among,
        none=none,
        wrong=wrong,
        count=clean["count"],
        apart=apart if clean["apart"] else "none does",
    )
    return head + "".join(_row(entry) for entry in entries)


def _kind(entry: Mapping[str, Any]) -> str:
    """Whether the suspects are the injected phenomenon, hold it, are none, or are others."""
    suspects = (entry["where"] or {}).get("suspects", [])
    if suspects == [entry["injected"]]:
        return "named"
    if entry["injected"] in suspects:
        return "among"
    return "wrong" if suspects else "none"


def _row(entry: Mapping[str, Any]) -> str:
    where = entry["where"] or {"suspects": [], "ablations": {}}
    outcomes: Mapping[str, str] = where["ablations"]
    without = [
        ", ".join(_words(name) for name, outcome in outcomes.items() if outcome in kinds)
        for kinds in (("goes",), ("stays",), ("unclear", "not_rendered"))
    ]
    cells = [_words(entry["name"]), _words(entry["injected"]), ", ".join(map(_words, where["suspects"])), *without]
    return "| " + " | ".join(cells) + " |\n"


def _words(name: str) -> str:
    return name.replace("_", " ")
