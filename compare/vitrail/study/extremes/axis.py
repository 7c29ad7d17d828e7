"""An axis of the atlas: one quantity made extreme, one invariant that must survive it, in both engines.

The POV-Ray side is written by hand and *not* normalised: the atlas shows what the program does with a scene as it
stands. What our back end makes of the same scene is a third reading, ``povray_lowered``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from vitrail.base.engine_name import EngineName
from vitrail.base.record import JsonObject

ENGINES = tuple(EngineName)
TRACER, POVRAY = ENGINES


@dataclass(frozen=True)
class Tolerance:
    """Relative deviation that still counts as holding, and why it is not smaller."""

    value: float
    reason: str


@dataclass(frozen=True)
class Ray:
    """One ray to follow, with what to read from the vertices of its path (as ``vitrail trace --json`` prints them)."""

    origin: tuple[float, float, float]
    direction: tuple[float, float, float]
    read: Callable[[list[JsonObject]], float]
    branch: Literal["transmit", "reflect"] = "transmit"


@dataclass(frozen=True)
class Axis:
    """One axis; every function takes the value along it.

    ``scene`` gives the scene as YAML, ``sdl`` the same for POV-Ray as a user would write it. ``read`` turns an image
    (height, width, 3) into the measured number; where ``ray`` is given, the tracer follows that ray instead of
    rendering; where ``ledger`` is given, the tracer's number is what that makes of its ledger of photons. With
    ``is_binary`` the tracer's range is bisected over powers of two, because only those are exact. ``limit`` says in
    words what ends the range by the nature of numbers, where something does.
    """

    name: str
    quantity: str
    unit: str
    invariant: str
    values: tuple[float, ...]
    scene: Callable[[float], str]
    sdl: Callable[[float], str]
    expected: Callable[[float], float]
    tolerance: dict[EngineName, Tolerance]
    read: Callable[[np.ndarray, float], float] = lambda image, value: float(np.mean(image))
    ray: Callable[[float], Ray] | None = None
    ledger: Callable[[JsonObject], float] | None = None
    whole: bool = False
    is_binary: bool = False
    pixels: int = 4
    photons: int = 0
    limit: dict[EngineName, str] = field(default_factory=dict)
