"""The agreement of the engines as tables in Markdown; every number comes from ``agreement.json``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

BEGIN, END = "<!-- tables: begin -->", "<!-- tables: end -->"
"""What stands between these lines of a page is written by the program, everything else by people."""
HEADINGS = {
    "tracer-vs-povray": "The engines against each other",
    "povray-vs-truth": "POV-Ray against closed forms",
}


def write_agreement_page(page: Path, found: Mapping[str, Any]) -> None:
    """Replace the tables of a page, or begin one."""
    before, after = "# Agreement of the engines\n\n", ""
    if page.is_file():
        text = page.read_text(encoding="utf-8")
        before, _, rest = text.partition(BEGIN)
        after = rest.partition(END)[2].lstrip("\n")
    tables = "\n".join(agreement_lines(found))
    page.write_text(f"{before}{BEGIN}\n\n{tables}\n{END}\n" + (f"\n{after}" if after else ""), encoding="utf-8")


def agreement_lines(found: Mapping[str, Any]) -> list[str]:
    """All tables: a count, the largest difference of each number, what lies beyond the certificate, every row."""
    lines = [count_line(found), ""]
    for pair, heading in HEADINGS.items():
        lines += [f"## {heading}", "", *_summary_table(entry for entry in found["phenomena"] if entry["pair"] == pair)]
    beyond = [row for row in found["rows"] if row["beyond"] > 0]
    lines += ["## Beyond the certificate", "", *(_row_table(beyond) if beyond else ["Nothing.", ""])]
    lines += ["## Scene by scene", "", *_row_table(found["rows"])]
    return [*lines, "## How each scene was rendered", "", *_scene_table(found["scenes"])]


def count_line(found: Mapping[str, Any]) -> str:
    """The whole result in one sentence."""
    rows = found["rows"]
    count = {
        verdict: sum(row["verdict"] == verdict for row in rows) for verdict in ("agrees", "inconclusive", "deviates")
    }
    outside = sum(row["beyond"] > 0 for row in rows)
    return (
        f"{len(found['scenes'])} scenes, {len(rows)} numbers: {count['agrees']} agree, {count['inconclusive']} are too"
        f" noisy to say, {count['deviates']} deviate; {outside} lie beyond what the certificate alone allows."
    )


def _summary_table(entries: Iterable[Mapping[str, Any]]) -> list[str]:
    lines = [
        "| phenomenon | number | rows | median | largest | its interval | certificate | where | agree/open/deviate |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for entry in entries:
        row, verdicts = entry["largest"], entry["verdicts"]
        counted = "/".join(str(verdicts[each]) for each in ("agrees", "inconclusive", "deviates"))
        cells = [
            _words(entry["phenomenon"]),
            _metric(row | {"part": ""}),
            str(entry["rows"]),
            _short(entry["median"]),
            *_sizes(row),
            _place(row),
            counted,
        ]
        lines.append(_cells(cells))
    return [*lines, ""]


def _row_table(rows: Iterable[Mapping[str, Any]]) -> list[str]:
    lines = [
        "| phenomenon | scene | number | against | difference | interval | certificate | tolerance | verdict |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        against = {"tracer-vs-povray": "POV-Ray", "povray-vs-truth": "truth"}[row["pair"]]
        verdict = row["verdict"] + (f" ({row['cause']})" if row["cause"] else "")
        sizes = [*_sizes(row), _short(row["tolerance"]), verdict]
        lines.append(_cells([_words(row["phenomenon"]), _place(row), _metric(row), against, *sizes]))
    return [*lines, ""]


def _scene_table(scenes: Iterable[Mapping[str, Any]]) -> list[str]:
    lines = ["| scene | samples | photons | tracer CPU s | POV-Ray CPU s |", "|---|---|---|---|---|"]
    for scene in scenes:
        settings, cpu = scene["settings"], scene["cpu_s"]
        seconds = [str(cpu.get(engine, "")) for engine in ("tracer", "povray")]
        lines.append(_cells([scene["name"], str(settings["samples"]), f"{settings['photons'] or 0:g}", *seconds]))
    return [*lines, ""]


def _sizes(row: Mapping[str, Any]) -> list[str]:
    return [_short(row["difference"]), f"{_short(row['low'])} to {_short(row['high'])}", _short(row["certificate"])]


def _place(row: Mapping[str, Any]) -> str:
    return f"{row['scene']}.{row['observation']}"


def _metric(row: Mapping[str, Any]) -> str:
    name = _words(row["metric"]) + (f" {row['part'].replace('.', ' ')}" if row["part"] else "")
    return name if row["unit"] in ("", "1") else f"{name} [{row['unit']}]"


def _words(name: str) -> str:
    return name.replace("_", " ")


def _cells(cells: Iterable[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def _short(value: float) -> str:
    """Two digits, a true minus sign, no exponent for what people read easily."""
    if abs(value) < 1e-9:
        return "0"
    text = f"{value:.2g}" if 1e-4 <= abs(value) < 1e4 else f"{value:.1e}"
    return text.replace("-", "−", 1) if value < 0 else text
