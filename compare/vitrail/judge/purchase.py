"""Samples and photons that were bought for what was open, with their predicted and their paid price."""

from __future__ import annotations

from collections.abc import Sequence

from pydantic import Field

from vitrail.base.record import Record

CLOSE = 2.0
"""A price is predicted well where the bill is within this factor of it, up or down."""


class Purchase(Record):
    """One more look at some views of a scene: ``samples`` of a pixel by view, and ``photons`` that they share.

    Prices are CPU seconds of both engines together and of ordering photons between shooting and gathering; ``paid_s``
    is null until the look is done.
    """

    samples: dict[str, int]
    photons: int = Field(ge=0)
    numbers: int = Field(ge=1)
    predicted_s: float = Field(ge=0)
    paid_s: float | None = None

    @property
    def is_well_predicted(self) -> bool:
        return self.paid_s is not None and self.predicted_s / CLOSE <= self.paid_s <= self.predicted_s * CLOSE


class PriceScore(Record):
    """How well a run foresaw its prices: of ``bought`` purchases ``close`` cost within a factor 2 of the prediction."""

    bought: int = Field(ge=0)
    close: int = Field(ge=0)
    predicted_s: float = Field(ge=0)
    paid_s: float = Field(ge=0)


def price_score(purchases: Sequence[Purchase]) -> PriceScore:
    """The score of all purchases that have been paid."""
    paid = [each for each in purchases if each.paid_s is not None]
    return PriceScore(
        bought=len(paid),
        close=sum(each.is_well_predicted for each in paid),
        predicted_s=sum(each.predicted_s for each in paid),
        paid_s=sum(each.paid_s or 0.0 for each in paid),
    )
