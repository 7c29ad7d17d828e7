"""What the scan of the whole picture says in ``results.json``: every place where the engines differ."""

from __future__ import annotations

from pydantic import Field

from vitrail.base.record import Record
from vitrail.judge.comparison import Verdict


class DifferentPlace(Record):
    """A region in which the engines differ beyond noise and certificate.

    ``x_px``, ``y_px`` is a pixel in its middle, ``width_px`` and ``height_px`` its box. ``object`` is what the camera
    sees there first, ``layer`` the tracer's light that is most like the difference. ``tracer`` and ``povray`` are mean
    radiances of all channels, W sr^-1 m^-2; ``tolerance`` is what was allowed of their difference, ``standard_error``
    its noise. ``excess`` is what is left of it, in standard errors. ``observations`` name the patches that hold most of
    it; their numbers have judged it already.
    """

    x_px: int
    y_px: int
    width_px: int
    height_px: int
    pixels: int
    object: str = ""
    layer: str = ""
    tracer: float
    povray: float
    tolerance: float = Field(ge=0)
    standard_error: float = Field(ge=0)
    excess: float
    observations: tuple[str, ...] = ()
    deviates: bool = False
    words: str


class ScanResult(Record):
    """The whole picture held against the other engine's.

    ``threshold`` is the excess that a picture of equal engines passes at ``false_alarm_rate``; ``picture`` shows the
    difference over its noise, full colour at the threshold. ``more`` counts the places beyond those that are listed.
    ``verdict`` is `deviates` where a place outside the patches differs beyond everything stated by a good margin.
    """

    threshold: float
    false_alarm_rate: float
    picture: str = ""
    places: tuple[DifferentPlace, ...] = ()
    more: int = Field(default=0, ge=0)
    verdict: Verdict = Verdict.AGREES
