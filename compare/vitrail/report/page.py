"""How numbers and words of ``results.json`` are written on the page: formatting, glyphs, order. Nothing is computed."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from markupsafe import Markup
from pydantic import JsonValue

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import Bound, Comparison, ObservationResult, Pair, Verdict
from vitrail.judge.records import Results, SceneResult, Status
from vitrail.judge.scan_records import DifferentPlace

GLYPHS = {"agrees": "✓", "deviates": "✕", "inconclusive": "?", "unjudged": "–"}
ORDER = ("unjudged", "deviates", "inconclusive", "agrees")
PREFIXES = ((1e-9, "n"), (1e-6, "µ"), (1e-3, "m"), (1.0, ""), (1e3, "k"))
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
"""Digits of a unit are exponents."""

ENGINE_NAMES = {"tracer": "Tracer", "povray": "POV-Ray"}
"""Engines as people write them, the tracer first."""

STATUS_WORDS = {
    Status.JUDGED: "judged",
    Status.GATE_FAILED: "a gate failed",
    Status.SCENE_ERROR: "scene error",
    Status.NOT_TRANSLATABLE: "not translatable",
    Status.ENGINE_FAILED: "an engine failed",
    Status.DEFECT: "a defect of Vitrail",
    Status.INTERRUPTED: "interrupted",
}


def number(value: float | None, digits: int = 4) -> str:
    """A number at ``digits`` significant figures with a true minus sign; large and tiny ones in powers of ten."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    if not 1e-4 <= abs(value) < 1e6:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
        return f"{mantissa}e{int(exponent)}".replace("-", "−")
    decimals = max(digits - 1 - math.floor(math.log10(abs(value))), 0)
    text = f"{value:,.{decimals}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return text.replace("-", "−").replace(",", "\u2009")


def short(value: float) -> str:
    """Two digits, a true minus sign, no exponent for what people read easily."""
    if abs(value) < 1e-9:
        return "0"
    text = f"{value:.2g}" if 1e-4 <= abs(value) < 1e4 else f"{value:.1e}"
    return text.replace("-", "−", 1) if value < 0 else text


def quantity(value: float | None, unit: str, digits: int = 4) -> str:
    """A number with its unit; metres take the prefix that keeps the number between 1 and 1000."""
    if value is None:
        return "–"
    if unit == "m" and value != 0:
        scale, prefix = prefix_for(abs(value))
        return f"{number(value / scale, digits)}\u202f{prefix}m"
    if unit in ("", "1"):
        return number(value, digits)
    return f"{number(value, digits)}\u202f{raised(unit)}"


@dataclass(frozen=True)
class NumberRow:
    """The numbers of one comparison in one unit, as they stand in the table."""

    unit: str
    value: str
    ideal: str
    difference: str
    tolerance: str


def row(comparison: Comparison) -> NumberRow:
    """All lengths of a row share the prefix that suits the largest of them."""
    numbers = (comparison.value, comparison.ideal, comparison.difference, comparison.tolerance)
    scale, unit = 1.0, "" if comparison.unit in ("", "1") else raised(comparison.unit)
    if comparison.unit == "m":
        scale, prefix = prefix_for(max(abs(each) for each in numbers))
        unit = f"{prefix}m"
    # A difference to the digits of the tolerance: what is far below it is no finding.
    value, ideal = (number(each / scale) for each in numbers[:2])
    return NumberRow(
        unit, value, ideal, number(comparison.difference / scale, 3), number(comparison.tolerance / scale, 3)
    )


def prefix_for(size: float) -> tuple[float, str]:
    """The scale and the prefix that leave a length between 1 and 1000."""
    fitting = [entry for entry in PREFIXES if entry[0] <= size * 1.0000001]
    return max(fitting) if fitting else (PREFIXES[0] if size > 0 else (1.0, ""))


def raised(unit: str) -> str:
    """A unit with its exponents raised: ``W sr^-1 m^-2`` becomes W sr⁻¹ m⁻²."""
    return unit.translate(RAISED).replace("^", "")


def percent(value: float) -> str:
    return f"{number(100 * value, 3)}\u202f%"


def words(name: str) -> str:
    """A name as it is read: ``flux_ratio.red`` becomes ``flux ratio, red``."""
    return name.replace("_", " ").replace(".", ", ")


def unbroken(statement: str) -> str:
    """A sentence whose numbers keep their units on the same line."""
    return re.sub(r"(?<=\d) (?=(%|m|mm|µm)(\W|$))", "\u202f", statement)


def points(outline: Iterable[tuple[float, float]]) -> str:
    """Corners as SVG wants them."""
    return " ".join(f"{x:g},{y:g}" for x, y in outline)


def box(place: DifferentPlace) -> Markup:
    """The box of a place as attributes of an SVG rectangle, a little wider than the place."""
    width, height = place.width_px + 4, place.height_px + 4
    x, y = place.x_px + 0.5 - width / 2, place.y_px + 0.5 - height / 2
    return Markup('x="{:g}" y="{:g}" width="{}" height="{}"').format(x, y, width, height)


def side_name(side: str) -> str:
    """The name of an image's maker as people write it."""
    return {"povray": "POV-Ray", "tracer": "Tracer", "truth": "Closed form", "stored": "Stored reference"}.get(
        side, side.capitalize()
    )


def verdict_key(verdict: Verdict | None) -> str:
    return "unjudged" if verdict is None else verdict.value


def scene_phenomena(scene: SceneResult) -> dict[str, str]:
    """Phenomenon to the worst verdict among the scene's observations of it, in the order of the vocabulary."""
    found: dict[str, str] = {}
    for phenomenon in Phenomenon:
        keys = [verdict_key(entry.verdict) for entry in scene.observations if entry.phenomenon is phenomenon]
        if keys:
            found[phenomenon.value] = min(keys, key=ORDER.index)
    return found


def run_phenomena(results: Results) -> list[str]:
    """The phenomena that any scene of the run observes, in the order of the vocabulary."""
    seen = {entry.phenomenon for scene in results.scenes for entry in scene.observations}
    return [phenomenon.value for phenomenon in Phenomenon if phenomenon in seen]


def worst_first(scenes: Iterable[SceneResult]) -> list[SceneResult]:
    """What failed, what deviates, then everything else by its widest bound in tolerances, the widest first."""
    return sorted(scenes, key=_worst_key)


def _worst_key(scene: SceneResult) -> tuple[int, float, int, str]:
    place = ORDER.index(verdict_key(scene.verdict))
    wrong = place if scene.verdict in (None, Verdict.DEVIATES) else len(ORDER)
    return wrong, -_width(scene.bound), place, scene.name


def by_pair(observation: ObservationResult) -> list[tuple[Pair, list[Comparison]]]:
    """The comparisons of an observation by who is held against whom, in the order of the vocabulary of pairs."""
    grouped = [(pair, [entry for entry in observation.comparisons if entry.pair is pair]) for pair in Pair]
    return [(pair, comparisons) for pair, comparisons in grouped if comparisons]


def headline(scene: SceneResult) -> list[tuple[ObservationResult, Comparison, int]]:
    """What a reader must see next: of every observation with the scene's verdict the comparison that is furthest off,
    and how many more there are; nothing for a scene that agrees."""
    found = []
    for observation in scene.observations:
        if observation.verdict is Verdict.AGREES or observation.verdict is not scene.verdict:
            continue
        same = [entry for entry in observation.comparisons if entry.verdict is observation.verdict]
        if same:
            found.append((observation, furthest_off(same), len(same) - 1))
    return found


def furthest_off(comparisons: Sequence[Comparison]) -> Comparison:
    """Of several numbers the one whose bound is most tolerances wide."""
    return max(comparisons, key=lambda entry: _width(entry.bound))


def _width(bound: Bound | None) -> float:
    """How wide a bound is, in tolerances; 0 in a record that has none."""
    return bound.over_tolerance or 0.0 if bound is not None else 0.0


def flat(record: Mapping[str, JsonValue], prefix: str = "") -> list[tuple[str, JsonValue]]:
    """A nested mapping as rows of dotted key and value, for a table of settings."""
    rows: list[tuple[str, JsonValue]] = []
    for key, value in record.items():
        name = f"{prefix}{key}"
        if isinstance(value, Mapping):
            rows.extend(flat(value, f"{name}."))
        else:
            rows.append((name, value))
    return rows


def setting(value: JsonValue) -> str:
    """A value of a settings table: numbers as numbers, lists with commas, nothing for absent."""
    if isinstance(value, bool) or value is None:
        return {True: "yes", False: "no", None: "–"}[value]
    if isinstance(value, (int, float)):
        return number(float(value), 6)
    if isinstance(value, (list, tuple)):
        return ", ".join(setting(item) for item in value)
    return str(value)


def confidence(level: float) -> str:
    """A level near 1 as a percentage with enough nines: 0.99987 becomes 99.987 %."""
    missing_percent = max(100 * (1 - level), 1e-12)
    decimals = max(0, math.ceil(-math.log10(missing_percent)) + 1)
    text = f"{100 * level:.{decimals}f}"
    return f"{text.rstrip('0').rstrip('.') if '.' in text else text}\u202f%"


def factor(value: float) -> str:
    """How many times the samples: rounded up, and never less than a little more."""
    return f"{number(max(math.ceil(value * 10) / 10, 1.1), 3)} times"


def cpu(scene: SceneResult, engine: str) -> str:
    """CPU seconds of one engine for the matrix of all scenes."""
    return next((quantity(run.cpu_s, "s", 3) for run in scene.engines if run.engine == engine), "–")


def lower_first(text: str) -> str:
    """Inside a sentence: ``Closed form`` becomes ``closed form``; a proper name such as POV-Ray stays."""
    return text if text[:2].isupper() else text[:1].lower() + text[1:]
