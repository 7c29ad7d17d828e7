"""The engines that are installed here, by name."""

from __future__ import annotations

from typing import TYPE_CHECKING, assert_never

from vitrail.base.engine_name import EngineName

if TYPE_CHECKING:
    from vitrail.engines.povray import Povray
    from vitrail.engines.tracer import Tracer


def engine_named(name: EngineName, timeout_s: float | None = None) -> Tracer | Povray:
    """The engine of that name; one rendering may take ``timeout_s``, or what the engine itself allows."""
    # Load the one that is asked for: POV-Ray's side reads images, which takes as long as a small rendering.
    match name:
        case EngineName.TRACER:
            from vitrail.engines.tracer import Tracer

            return Tracer(timeout_s=timeout_s)
        case EngineName.POVRAY:
            from vitrail.engines.povray import Povray

            return Povray() if timeout_s is None else Povray(timeout_s=timeout_s)
        case _:
            assert_never(name)
