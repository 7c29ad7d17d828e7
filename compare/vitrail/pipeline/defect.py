"""A known mistake that is put into a comparison on purpose, to see which phenomenon turns red."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from vitrail.lower.povray import PovrayScene
from vitrail.scene.model import Scene


@dataclass(frozen=True)
class Defect:
    """A mistake between scene and rendering. Empty: none.

    ``povray`` changes the translated scene (its text, its gains), ``tracer`` the lowered scene; ``misread_by_povray``
    and ``misread_by_tracer`` change the scene that one back end reads, as a lowering that misunderstands it would. A
    change of nodes raises NothingToEdit where the translated scene has none of them.
    """

    name: str = ""
    misread_by_povray: Callable[[Scene], Scene] = field(default=lambda scene: scene)
    misread_by_tracer: Callable[[Scene], Scene] = field(default=lambda scene: scene)
    povray: Callable[[PovrayScene], PovrayScene] = field(default=lambda scene: scene)
    tracer: Callable[[dict[str, Any]], dict[str, Any]] = field(default=lambda lowered: lowered)
