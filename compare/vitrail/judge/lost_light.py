"""Light of a view that no engine can show: cut by the scene's limits, or dropped by POV-Ray with weak branches.

The tracer drops no branch, so it knows what light comes by the weak ones, and its ledger says so. Of what limits cut it
knows the share of a look, by how light divides at the faces, and not what the branch would have met.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from pydantic import Field

from vitrail.base.record import Record
from vitrail.judge.comparison import TolerancePart
from vitrail.judge.rules import Rule

STATED = 2
"""Branches at the limit that the certificate already states of every path."""


LEAST_KEPT = 1e-3
"""Where POV-Ray keeps less than this of the light, it shows nothing of it."""


class LostLight(Record):
    """Mean shares over one picture.

    ``cut`` of a look by max_reflections and max_transmissions, in both engines; ``dropped`` of the light, with branches
    below ``least_branch`` of a look, in POV-Ray alone.
    """

    cut: float = Field(default=0.0, ge=0)
    dropped: float = Field(default=0.0, ge=0, le=1)
    least_branch: float = Field(default=0.0, ge=0)

    @property
    def unstated(self) -> float:
        """How much more light there is than POV-Ray shows, beyond what its certificate states."""
        kept = max(1.0 - self.dropped, LEAST_KEPT)
        return max(0.0, self.dropped / kept - STATED * self.least_branch)

    def parts(self, rule: Rule, ideal: float, half_edge_m: float, *, is_translated: bool) -> Iterator[TolerancePart]:
        """What this allows a number to be off, in its unit; ``is_translated`` where POV-Ray takes part."""
        if self.cut > 0:
            reason = f"the limits of `transport` cut up to {self.cut:.2g} of the light of this view"
            yield TolerancePart(source="cut", amount=rule.widening(self.cut, ideal, half_edge_m), reason=reason)
        if is_translated and self.unstated > 0:
            reason = f"POV-Ray drops branches below {self.least_branch:g}, {self.dropped:.2g} of this view's light"
            yield TolerancePart(
                source="dropped", amount=rule.widening(self.unstated, ideal, half_edge_m), reason=reason
            )


def lost_light(records: Mapping[str, Mapping[str, Any]], view: str | None) -> LostLight:
    """What run records by engine say of a view, for None of the scene's own picture; nothing where they do not say."""
    tracer, povray = records.get("tracer", {}), records.get("povray", {})
    of_view: Mapping[str, Any] = next((each for each in tracer.get("views", ()) if each["name"] == view), {})
    ledger = (tracer if view is None else of_view).get("camera_ledger", {})
    least = povray.get("adc_bailout", 0.0)
    # The ledger has decades: the one at the limit or above it loses as much or more.
    weak = sorted((each["below"], each["share"]) for each in ledger.get("weak_branches", ()))
    dropped = next((share for below, share in weak if below >= least), 0.0) if least > 0 else 0.0
    return LostLight(cut=ledger.get("cut", 0.0), dropped=dropped, least_branch=least)
