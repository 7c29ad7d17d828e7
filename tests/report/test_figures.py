"""Where the marks of a bar and of a plot go, and that they are drawn there."""

from __future__ import annotations

import re

import pytest

from tests.report.synthetic import compared, observation
from vitrail.judge.comparison import Pair
from vitrail.report.environment import pages
from vitrail.report.figures import BAR_WIDTH, interval_bar, profile_plot, ticks


def test_ticks_are_round_and_inside() -> None:
    assert ticks(-0.02, 0.02, 4) == pytest.approx([-0.02, -0.01, 0.0, 0.01, 0.02])
    assert ticks(0.0, 1.3, 4) == pytest.approx([0.0, 0.5, 1.0])


def test_a_bar_has_zero_in_its_middle_and_the_tolerance_about_it() -> None:
    bar = interval_bar(compared(Pair.TRACER_POVRAY, "flux_ratio", 1.01, 0.001, 0.02))
    assert bar.zero == BAR_WIDTH / 2 and bar.band + bar.band_width / 2 == pytest.approx(bar.zero, abs=0.01)
    # The scale ends at 1.6 tolerances, 6 units before the edge.
    assert bar.band_width == pytest.approx(2 * (BAR_WIDTH / 2 - 6) / 1.6, abs=0.01)
    # The difference is half the tolerance: half way from zero to the edge of the band.
    assert bar.dot - bar.zero == pytest.approx(bar.band_width / 4, abs=0.01)
    assert bar.low < bar.dot < bar.high and bar.ends == [bar.low, bar.high] and bar.clipped == 0


@pytest.mark.parametrize(("value", "sign"), [(3.0, 1), (-3.0, -1)])
def test_a_difference_far_outside_is_an_arrow_at_the_edge(value: float, sign: int) -> None:
    bar = interval_bar(compared(Pair.TRACER_POVRAY, "flux_ratio", value, 0.001, 0.02))
    assert bar.clipped == sign and bar.ends == []
    drawn = pages().from_string('{% import "figures.svg" as svg %}{{ svg.bar(bar) }}').render(bar=bar)
    assert "<path" in drawn and "<circle" not in drawn


def test_a_plot_draws_every_side_and_the_band_where_the_error_is_known() -> None:
    plot = profile_plot(observation(1.3, 0.001).profiles[0])
    assert [curve.side for curve in plot.curves] == ["tracer", "povray", "truth"]
    # The band goes along value + error and back along value - error.
    assert [len(curve.band.split()) for curve in plot.curves] == [2 * 48, 0, 0]
    # The patch is 40 mm long, and its positions are told in millimetres.
    assert plot.metres == "mm" and [tick.label for tick in plot.across] == ["−20", "−10", "0", "10", "20"]
    drawn = pages().from_string('{% import "figures.svg" as svg %}{{ svg.plot(plot) }}').render(plot=plot)
    heights = [float(y) for y in re.findall(r"[-\d.]+,([-\d.]+)", plot.curves[0].line)]
    # The ring is brightest 10 mm from the middle, a quarter of the way; that is drawn highest, which is the least y.
    assert heights.index(min(heights)) in (11, 12)
    assert drawn.count("<polyline") == 3 and drawn.count("<polygon") == 1 and "Closed form" in drawn
