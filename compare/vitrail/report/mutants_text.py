"""The page of docs/studies/mutants: what the verdicts catch and by what name, from the stored numbers alone."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from vitrail.base.phenomenon import Phenomenon
from vitrail.report.mutants_ablated import ablation_text

ALONE = {"ssim": "SSIM < 0.95", "flip": "FLIP > 0.05", "relmse": "relMSE > 0.01"}

HEAD = """# Mutants: what the verdicts catch, and by what name

A mutant is one known mistake, put into the translator or the tracer on purpose. Each goes through a bench of {scenes}
scenes at normal quality, and the run must turn red and name the phenomenon that was broken.

    vitrail mutants --out out/mutants --publish docs/studies/mutants

makes this page, [mutants.json](mutants.json), [limits.json](limits.json) and [equal_runs.json](equal_runs.json); the
mutants take {cpu_s} CPU s. The study remembers what is done and goes on where it was stopped. A test holds this page to
those files.

**{caught} of {total} are caught, {named} are named by the right phenomenon ({share:.0f} %).** Closed forms blame an
engine for {blamed} mutants, and it is the spoilt one for {right}. Without any mutant the bench reports {clean}.

When several phenomena deviate, the one seen in the plainest scene is named: a scene rests on everything that its plan
requires, so the scene that requires least is the best witness. The rule, the bench and the mutants grew together: the
run before this one named 31 of 36, and four of its five failures were mutants that an engine or a gate refused before
anything was measured. So take the share for what this bench can tell apart, and not for a chance of unknown defects.
"""

ONE_NUMBER = """
## What one number over the picture would have said

Of the same pictures, at customary thresholds, at least one scene of the bench would have raised an alarm for so many
mutants. A scene that raises an alarm without any mutant tells nothing and is not counted.

| method | mutants noticed | of | phenomenon named | alarms without any mutant |
|---|---|---|---|---|
"""

LIMITS = """
## The smallest defects that must be seen

Four promises fix the tolerances in [thresholds.yaml](../../../references/thresholds.yaml): a caustic moved by 3 mm, a
flux wrong by 1 %, a tint of 2 % and a spread that lost 5 % deviate; half of each never agrees. Each is put into the
scene that the tracer reads (`vitrail mutants --limits`). *Off by* is the number that sees it best, with its interval;
*may be* is the tolerance.

"""

EQUAL = """
## False alarms

{pairs} pairs of renderings of the ball lens that differ in the seed alone, with no tolerance at all
([why](../../false-alarms.md)):

| stated rate for a suite | suites that raised an alarm |
|---|---|
"""


def mutants_text(found: Mapping[str, Any], limits: str, equal: Mapping[str, Any]) -> str:
    """The page in Markdown; ``limits`` is the table of the limits."""
    entries: Sequence[Mapping[str, Any]] = found["mutants"]
    blamed = [entry for entry in entries if entry["engine"]]
    head = HEAD.format(
        scenes=len(found["clean"]["scenes"]),
        cpu_s=found["cpu_s"],
        caught=found["caught"],
        named=found["named"],
        total=len(entries),
        share=100 * found["named"] / len(entries),
        blamed=len(blamed),
        right=sum(entry["engine"] == entry["injected_engine"] for entry in blamed),
        clean=found["clean"]["reported"] or "nothing",
    )
    rates = "".join(f"| {100 * row['rate']:g} % | {row['alarms']} of {row['suites']} |\n" for row in equal["rates"])
    pairs = max(row["suites"] for row in equal["rates"])
    return "".join(
        [
            head,
            _matrix(entries),
            _one_by_one(entries),
            ablation_text(found),
            _one_number(found),
            LIMITS,
            limits,
            EQUAL.format(pairs=pairs),
            rates,
        ]
    )


def _matrix(entries: Sequence[Mapping[str, Any]]) -> str:
    """Injected phenomenon (rows) against reported phenomenon (columns), counts."""
    reported = [p.value for p in Phenomenon if any(entry["reported"] == p.value for entry in entries)]
    columns: list[str | None] = (
        [*reported, None] if any(entry["reported"] is None for entry in entries) else [*reported]
    )
    lines = [
        "\n## Injected against reported\n",
        "| injected | " + " | ".join(_words(name or "nothing") for name in columns) + " |",
        "|---" * (len(columns) + 1) + "|",
    ]
    for row in (p.value for p in Phenomenon if any(entry["injected"] == p.value for entry in entries)):
        counts = [sum(e["injected"] == row and e["reported"] == column for e in entries) for column in columns]
        lines.append(f"| {_words(row)} | " + " | ".join(str(count or "") for count in counts) + " |")
    return "\n".join(lines) + "\n"


def _one_by_one(entries: Sequence[Mapping[str, Any]]) -> str:
    lines = [
        "\n## One by one\n",
        "*Engine* is the one that was spoilt, and the one that closed forms blame. *Seen by* is the number of tracer"
        "\nagainst POV-Ray that is furthest beyond its tolerance on the scene that the name comes from.\n",
        "| mutant | mistake | injected | reported | engine: spoilt, blamed | seen by | "
        + " | ".join(ALONE.values())
        + " |",
        "|---" * (6 + len(ALONE)) + "|",
    ]
    for entry in entries:
        alone = ["seen" if entry["alone"].get(name, {}).get("caught") else "missed" for name in ALONE]
        cells = [
            _words(entry["name"]),
            entry["what"],
            _words(entry["injected"]),
            entry["failure"] or _words(entry["reported"] or "nothing"),
            f"{entry['injected_engine']}, {entry['engine'] or 'no closed form'}",
            _seen_by(entry),
            *alone,
        ]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def _seen_by(entry: Mapping[str, Any]) -> str:
    witness = entry["witness"]
    if witness is None:
        return entry["scene"]
    off = f"{witness['difference']:.3g} ± {witness['half_width']:.2g}, may be {witness['tolerance']:.2g}"
    return f"{entry['scene']}: {witness['metric']} {off}"


def _one_number(found: Mapping[str, Any]) -> str:
    """How many mutants each method notices, and what it says of clean pictures."""
    entries = found["mutants"]
    rows = [f"| verdicts by phenomenon | {found['caught']} | {len(entries)} | {found['named']} | none |"]
    for name, words in ALONE.items():
        noticed = sum(bool(entry["alone"].get(name, {}).get("caught")) for entry in entries)
        false = ", ".join(found["clean"]["alone"][name]) or "none"
        rows.append(f"| {words} | {noticed} | {len(entries)} | 0 | {false} |")
    return ONE_NUMBER + "\n".join(rows) + "\n"


def _words(name: str) -> str:
    return name.replace("_", " ")


def write_mutants_text(
    target: Path, found: Mapping[str, Any], limits: Mapping[str, Any], limits_table: str, equal: Mapping[str, Any]
) -> Path:
    """README.md and the three files of data in ``target``; returns the page."""
    target.mkdir(parents=True, exist_ok=True)
    for name, data in (("mutants", found), ("limits", limits), ("equal_runs", equal)):
        (target / f"{name}.json").write_text(json.dumps(data, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    page = target / "README.md"
    page.write_text(mutants_text(found, limits_table, equal), encoding="utf-8")
    return page
