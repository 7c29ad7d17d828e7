"""Closed forms from ``references/analytic.yaml``: what each observation must measure, by formula and not by program.

    version: 1
    scenes:
      ball_lens:                    # the stem of the scene's file
        caustic:                    # the name of the observation
          context: {centre_m: [0, 0]}          # what the metrics must know beside the picture, optional
          profile: {along: u, positions_m: [...], values: [...]}    # luminance by formula, optional
          r50:                      # a metric
            value: 0.123
            formula: how the value follows, for a person to check
            source: "[O 1.6]"
            tolerance: {relative: 0.01, reason: why}       # optional; else thresholds.yaml
            povray: {relative: 0.02, reason: why}          # optional, for one side

A scene, an observation or a metric that the file names and the run lacks is an error, never a silent gap.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from vitrail.judge.comparison import Curve, TolerancePart
from vitrail.judge.reference_files import ReferencesError, read_yaml
from vitrail.metrics.measurement import Context
from vitrail.scene.model import Scene

ENTRY_KEYS = {"value", "formula", "source", "tolerance"}
RESERVED = {"context", "profile"}


@dataclass(frozen=True)
class Truth:
    """One value that a formula gives. ``tolerances`` by side; ``any`` is for every side without its own."""

    metric: str
    value: float
    formula: str
    source: str
    tolerances: Mapping[str, tuple[str, float, str]] = field(default_factory=dict)

    @property
    def origin(self) -> str:
        return f"{self.formula} {self.source}".strip()

    def tolerance(self, side: str) -> TolerancePart | None:
        """The tolerance the formula's author gave for a side, in the metric's unit, or None."""
        found = self.tolerances.get(side) or self.tolerances.get("any")
        if found is None:
            return None
        kind, amount, reason = found
        size = abs(self.value) if kind == "relative" else 1.0
        return TolerancePart(source="reference", amount=amount * size, reason=reason)


@dataclass(frozen=True)
class TrueProfile:
    """Luminance along an observation's patch by formula."""

    along: str
    positions_m: tuple[float, ...]
    values: tuple[float, ...]

    def curve(self) -> Curve:
        return Curve(side="truth", values=self.values)


@dataclass(frozen=True)
class SceneTruth:
    """What is known of one scene, by observation."""

    truths: Mapping[str, tuple[Truth, ...]] = field(default_factory=dict)
    contexts: Mapping[str, Context] = field(default_factory=dict)
    profiles: Mapping[str, TrueProfile] = field(default_factory=dict)

    def of(self, observation: str) -> tuple[Truth, ...]:
        return self.truths.get(observation, ())

    def context(self, observation: str) -> Context:
        return self.contexts.get(observation, Context())


def references_folder(scene_path: Path, given: Path | None = None) -> Path:
    """The folder of closed forms and accepted images: the given one, or the nearest ``references`` above the scene.

    Where there is none yet it is the one beside the scene, so that nothing of one project is ever taken for another's.
    Raises ReferencesError when the given one does not exist.
    """
    if given is not None:
        if not given.is_dir():
            raise ReferencesError(f"{given}: there is no such folder of references; correct --references")
        return given
    beside = scene_path.resolve().parent / "references"
    above = [folder / "references" for folder in scene_path.resolve().parents]
    return next((folder for folder in above if folder.is_dir()), beside)


def read_scene_truth(folder: Path, scene_name: str, scene: Scene) -> SceneTruth:
    """The closed forms of one scene; a scene without any is fine. Raises ReferencesError."""
    path = folder / "analytic.yaml"
    if not path.is_file():
        return SceneTruth()
    found = (read_yaml(path).get("scenes") or {}).get(scene_name) or {}
    known = {entry.name for entry in scene.observe}
    unknown = sorted(set(found) - known)
    if unknown:
        raise ReferencesError(
            f"{path}: {scene_name} has truths for {', '.join(unknown)}, which the scene does not observe;"
            " add the observation or drop the entry"
        )
    places = {name: f"{path}: {scene_name}.{name}" for name in found}
    return SceneTruth(
        truths={name: _truths(places[name], entry) for name, entry in found.items()},
        contexts={
            name: _context(places[name], entry["context"]) for name, entry in found.items() if "context" in entry
        },
        profiles={
            name: _profile(places[name], entry["profile"]) for name, entry in found.items() if "profile" in entry
        },
    )


def _truths(place: str, observation: Mapping[str, Any]) -> tuple[Truth, ...]:
    return tuple(
        _truth(f"{place}.{metric}", metric, entry) for metric, entry in observation.items() if metric not in RESERVED
    )


def _truth(place: str, metric: str, entry: Any) -> Truth:
    """One entry; everything it says is used, and value, formula and source it must say."""
    if not isinstance(entry, Mapping):
        raise ReferencesError(f"{place}: is {entry!r}; write value, formula and source")
    missing = sorted({"value", "formula", "source"} - set(entry))
    if missing:
        raise ReferencesError(f"{place}: lacks {', '.join(missing)}")
    value = entry["value"]
    if not _is_finite(value):
        raise ReferencesError(f"{place}.value: is {value!r}; write a finite number")
    sides = {"any" if key == "tolerance" else key: key for key in entry if key not in ENTRY_KEYS - {"tolerance"}}
    tolerances = {side: _tolerance(f"{place}.{key}", entry[key]) for side, key in sides.items()}
    return Truth(metric, float(value), str(entry["formula"]).strip(), str(entry["source"]).strip(), tolerances)


def _tolerance(place: str, entry: Any) -> tuple[str, float, str]:
    """(kind, amount, reason) of ``{relative: x, reason: ...}`` or ``{absolute: x, reason: ...}``."""
    kinds = [kind for kind in ("relative", "absolute") if isinstance(entry, Mapping) and kind in entry]
    if len(kinds) != 1 or not str(entry.get("reason", "")).strip() or set(entry) - {*kinds, "reason"}:
        raise ReferencesError(f"{place}: a tolerance has one of `relative` or `absolute`, and a `reason`")
    amount = entry[kinds[0]]
    if not _is_finite(amount) or amount < 0:
        raise ReferencesError(f"{place}.{kinds[0]}: is {amount!r}; write a finite number at or above 0")
    return kinds[0], float(amount), str(entry["reason"]).strip()


def _is_finite(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _context(place: str, entry: Any) -> Context:
    """Fields of Context by name; lists become tuples."""
    names = {each.name for each in fields(Context)}
    if not isinstance(entry, Mapping) or set(entry) - names:
        raise ReferencesError(f"{place}.context: knows {', '.join(sorted(names))}, not {set(entry) - names}")
    return Context(**{key: _tupled(value) for key, value in entry.items()})


def _tupled(value: Any) -> Any:
    return tuple(_tupled(item) for item in value) if isinstance(value, list) else value


def _profile(place: str, entry: Any) -> TrueProfile:
    try:
        found = TrueProfile(str(entry["along"]), _tupled(entry["positions_m"]), _tupled(entry["values"]))
    except (KeyError, TypeError):
        raise ReferencesError(f"{place}.profile: takes along, positions_m and values") from None
    if len(found.positions_m) != len(found.values):
        raise ReferencesError(f"{place}.profile: has {len(found.positions_m)} positions for {len(found.values)} values")
    return found
