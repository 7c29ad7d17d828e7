"""How deep POV-Ray traces: one counter for what the scene counts apart.

POV-Ray answers black beyond ``max_trace_level``; a level is a face crossed or mirrored at, plus one for what is seen at
the end [P 4.3, 2.7]. The scene limits reflections and transmissions separately, so their sum is the level.
"""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.plan.plan import Plan

LIMIT = 256
"""POV-Ray caps max_trace_level here without a word [P 4.3]."""
MARGIN = 2
"""Levels beyond a proven chain, so that a path that uses them all shows an error."""


@dataclass(frozen=True)
class TraceDepth:
    """``level`` for the scene; ``wanted`` before POV-Ray's cap; proven chains leave levels unused."""

    level: int
    wanted: int
    is_proven: bool


def trace_depth(plan: Plan) -> TraceDepth:
    chain = plan.chain
    wanted = chain.reflections + chain.transmissions + (MARGIN if chain.proven else 1)
    return TraceDepth(min(wanted, LIMIT), wanted, chain.proven)
