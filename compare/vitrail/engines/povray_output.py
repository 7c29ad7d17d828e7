"""What POV-Ray says about a run, read from its console text [P 8.2]."""

from __future__ import annotations

import re
from dataclasses import dataclass

_VERSION = re.compile(r"POV-Ray\s+(\d+)\.(\d+)(\S*)")
_PHASE = r"{name}:.*?\n\s*using \d+ thread\(s\) with ([\d.]+) CPU-seconds total"


@dataclass(frozen=True)
class Statistics:
    """Counters and CPU seconds of one run; what POV-Ray does not mention is 0."""

    photons_shot: int
    photons_stored: int
    gather_calls: int
    rays: int
    shadow_tests: int
    cut_by_weight: int
    deepest_level: int
    level_limit: int
    cpu_s: dict[str, float]


def version_of(text: str) -> tuple[int, int, str] | None:
    """(3, 7, "3.7.0.10.unofficial") from the banner, or None when there is none."""
    match = _VERSION.search(text)
    if match is None:
        return None
    return int(match[1]), int(match[2]), f"{match[1]}.{match[2]}{match[3]}"


def statistics_of(text: str) -> Statistics:
    """The statistics of a finished run."""
    level = re.search(r"Max Level:\s*(\d+)/(\d+)", text)
    return Statistics(
        photons_shot=_count(r"Number of photons shot:\s*(\d+)", text),
        photons_stored=_count(r"Surface photons stored:\s*(\d+)", text),
        gather_calls=_count(r"Gather function called:\s*(\d+)", text),
        rays=_count(r"Rays:\s*(\d+)", text),
        shadow_tests=_count(r"Shadow Ray Tests:\s*(\d+)", text),
        cut_by_weight=_count(r"Saved:\s*(\d+)", text),
        deepest_level=int(level[1]) if level else 0,
        level_limit=int(level[2]) if level else 0,
        cpu_s={
            name: _seconds(_PHASE.format(name=label), text)
            for name, label in (
                ("parse", "Parse Time"),
                ("bounding", "Bounding Time"),
                ("photon", "Photon Time"),
                ("radiosity", "Radiosity Time"),
                ("trace", "Trace Time"),
            )
        },
    )


def complaint_of(text: str) -> str:
    """POV-Ray's own words about a failure: from its first error on, or its last lines."""
    rows = [row.strip() for row in text.replace("\r", "\n").split("\n") if row.strip()]
    for index, row in enumerate(rows):
        if re.search(r"error|cannot|failed", row, re.IGNORECASE) and "user configuration file" not in row:
            return " ".join(rows[index : index + 4])
    return " ".join(rows[-3:]) or "(it said nothing)"


def progress_of(text: str) -> tuple[int, int] | None:
    """(done, total) pixels from the last progress message in a piece of output."""
    found = re.findall(r"Rendered (\d+) of (\d+) pixels", text)
    return (int(found[-1][0]), int(found[-1][1])) if found else None


def _count(pattern: str, text: str) -> int:
    match = re.search(pattern, text)
    return int(match[1]) if match else 0


def _seconds(pattern: str, text: str) -> float:
    match = re.search(pattern, text)
    return float(match[1]) if match else 0.0
