"""What is left of the suspects when one thing after the other is switched off: made-up numbers, known answers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import (
    AblationOutcome,
    LayerShare,
    ObservationResult,
    Pair,
    PatchRecord,
    TolerancePart,
    Whereabouts,
)
from vitrail.judge.patch_light import PatchLight, is_too_weak, layer_shares
from vitrail.judge.verdict import Measured, Noise, decide, overall
from vitrail.judge.whereabouts import Switched, whereabouts
from vitrail.metrics.measurement import Measurement, StudentInterval

P = Phenomenon
LEVEL = 0.99
PATCH = PatchRecord(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1))
GLASS = frozenset({P.REFRACTION, P.CAUSTIC, P.COLOURED_TRANSMISSION})
REQUIRED = GLASS | {P.DIFFUSION}


def observed(phenomenon: Phenomenon = P.CAUSTIC, error: float = 0.0, **off_by: float) -> ObservationResult:
    """An observation whose numbers differ from 1 by so much, with a tolerance of 0.01."""
    part = TolerancePart(source="threshold", amount=0.01, reason="for this test")
    comparisons = tuple(
        decide(Measured(Pair.TRACER_POVRAY, metric, "1", 1 + value, 1.0, Noise(error)), [part], LEVEL)
        for metric, value in off_by.items()
    )
    verdict = overall(each.verdict for each in comparisons)
    assert verdict is not None
    return ObservationResult(name="spot", phenomenon=phenomenon, patch=PATCH, comparisons=comparisons, verdict=verdict)


def light(tracer: float = 1.0, povray: float = 0.5, error: float = 0.0, **layers: float) -> PatchLight:
    difference = tracer - povray
    interval = StudentInterval.about(difference, error, 24, LEVEL, "for this test")
    found = Measurement("mean_difference.red", difference, "W", 0.0, interval=interval)
    parts = {P(name): np.full(3, value) for name, value in layers.items()}
    return PatchLight(np.full(3, tracer), np.full(3, povray), (found,) * 3, parts)


def switched(off: str, after: ObservationResult | None, *touched: Phenomenon, **more: object) -> Switched:
    absent = frozenset(touched or (P(off),))
    usual = Switched(off, f"{off} is off", absent, absent, False, after, light() if after else None)
    return replace(usual, **more)  # type: ignore[arg-type]


def told(before: ObservationResult, *looks: Switched, bright: PatchLight | None = None) -> Whereabouts:
    found = whereabouts(before, bright or light(), looks, REQUIRED, LEVEL)
    assert found is not None
    return found


GONE, THERE, LESS = observed(flux_ratio=0.0), observed(flux_ratio=0.5), observed(flux_ratio=0.2)


def test_what_goes_with_one_and_stays_with_the_others_lives_there() -> None:
    found = told(
        THERE,
        switched("coloured_transmission", THERE),
        switched("refraction", THERE),
        switched("specular bodies", GONE, *GLASS),
    )
    assert found.suspects == (P.CAUSTIC,)
    assert [each.outcome for each in found.ablations] == [
        AblationOutcome.STAYS,
        AblationOutcome.STAYS,
        AblationOutcome.GOES,
    ]
    assert found.reason == (
        "in caustic: it goes when specular bodies is off, and it stays when coloured_transmission is off"
        " and when refraction is off"
    )


def test_what_stays_whatever_is_off_is_beneath() -> None:
    found = told(THERE, switched("refraction", THERE), switched("specular bodies", THERE, *GLASS))
    assert found.suspects == (P.DIFFUSION,) and "beneath all of it" in found.reason


def test_what_cannot_be_told_apart_is_not() -> None:
    found = told(THERE, switched("refraction", GONE, P.REFRACTION, P.CAUSTIC))
    assert found.suspects == (P.REFRACTION, P.CAUSTIC) and "not told apart" in found.reason


def test_contradiction_names_nothing() -> None:
    found = told(THERE, switched("refraction", GONE), switched("coloured_transmission", GONE))
    assert found.suspects == () and found.reason.startswith("in no single phenomenon")


@pytest.mark.parametrize(
    "after",
    [LESS, observed(flux_ratio=-0.5), observed(flux_ratio=0.0, error=0.2), observed(flux_ratio=0.5, error=0.2)],
    ids=["less", "to the other side", "noise about none", "noise about all"],
)
def test_neither_none_nor_all_of_it_tells_nothing(after: ObservationResult) -> None:
    found = told(THERE, switched("refraction", after))
    assert found.ablations[0].outcome is AblationOutcome.UNCLEAR
    assert set(found.suspects) == REQUIRED


def test_one_number_that_still_deviates_is_enough_for_doubt() -> None:
    before = observed(flux_ratio=0.5, r50_ratio=0.1)
    found = told(before, switched("refraction", observed(flux_ratio=0.0, r50_ratio=0.1)))
    assert found.ablations[0].outcome is AblationOutcome.UNCLEAR


def test_numbers_of_nothing_do_not_hide_that_the_observed_phenomenon_was_it() -> None:
    """Without a spectrum the order of its colours is chance, but its place is right again; or its light is."""
    before = observed(P.CAUSTIC, place_shift=0.5, colour_order=0.2)
    chance = observed(P.CAUSTIC, place_shift=0.0, colour_order=0.2)
    assert told(before, switched("caustic", chance)).ablations[0].outcome is AblationOutcome.GOES
    assert told(before, switched("refraction", chance)).ablations[0].outcome is AblationOutcome.UNCLEAR
    before = observed(P.CAUSTIC, indirect_ratio=100.0, flux_ratio=0.5)
    chance = observed(P.CAUSTIC, indirect_ratio=70.0, flux_ratio=0.0)
    assert told(before, switched("caustic", chance)).ablations[0].metric == "indirect_ratio"
    chance = observed(P.CAUSTIC, indirect_ratio=7.0, flux_ratio=0.0)
    found = told(before, switched("caustic", chance)).ablations[0]
    assert (found.metric, found.outcome) == ("flux_ratio", AblationOutcome.GOES)


def test_a_dark_patch_agrees_for_want_of_light() -> None:
    dark = light(0.01, 0.01)
    found = told(THERE, switched("reflection", GONE, light=dark))
    assert found.ablations[0].outcome is AblationOutcome.UNCLEAR and "dark" in found.reason
    found = told(THERE, switched("caustic", GONE, *GLASS, light=dark, darkens=True))
    assert found.ablations[0].outcome is AblationOutcome.GOES


def test_the_mean_light_tells_where_no_number_is_left() -> None:
    gone = told(THERE, switched("refraction", observed(other=0.0), light=light(0.7, 0.7)))
    assert (gone.ablations[0].outcome, gone.ablations[0].metric) == (AblationOutcome.GOES, "mean_difference.red")
    stays = told(THERE, switched("refraction", observed(other=0.0), light=light(1.4, 0.8)))
    assert stays.ablations[0].outcome is AblationOutcome.STAYS
    alike = told(THERE, switched("refraction", observed(other=0.0), light=light(1.4, 0.8)), bright=light(1, 1))
    assert alike.ablations[0].outcome is AblationOutcome.UNCLEAR


def test_what_was_not_rendered_says_why_and_counts_for_nothing() -> None:
    found = told(THERE, switched("refraction", None, reason="about 9 CPU s each, and 2 are left"))
    assert set(found.suspects) == REQUIRED and "not tried: refraction (about 9 CPU s each" in found.reason


def test_a_scene_that_requires_nothing_else_needs_no_rendering() -> None:
    found = whereabouts(THERE, light(), [], frozenset({P.DIFFUSION}), LEVEL)
    assert found is not None and found.suspects == (P.DIFFUSION,) and "requires nothing else" in found.reason


def test_engines_that_agree_have_no_whereabouts() -> None:
    assert whereabouts(GONE, light(), [switched("refraction", GONE)], REQUIRED, LEVEL) is None


def test_a_layer_with_less_light_than_the_excess_is_not_it() -> None:
    bright = light(1.0, 0.5, caustic=0.01, refraction=0.6)
    found = told(THERE, switched("coloured_transmission", THERE), bright=bright)
    needed = {each.layer: each.needed for each in found.layers}
    assert needed == {P.CAUSTIC: pytest.approx(50), P.REFRACTION: pytest.approx(0.5 / 0.61)}
    assert P.CAUSTIC not in found.suspects and P.REFRACTION in found.suspects
    assert "caustic acts on 1 % of the light, which is too little" in found.reason
    # An index shapes the caustic too: where no glass is seen, bending is still a suspect.
    unseen = told(THERE, switched("coloured_transmission", THERE), bright=light(1.0, 0.5, caustic=0.6, refraction=0.0))
    assert {P.CAUSTIC, P.REFRACTION} <= set(unseen.suspects)


def test_layers_say_nothing_of_light_that_povray_has_more_of_nor_of_a_shift() -> None:
    assert all(each.needed is None for each in layer_shares(light(0.5, 1.0, caustic=0.01), LEVEL, mean_deviates=True))
    assert all(each.needed is None for each in layer_shares(light(1.0, 0.5, caustic=0.01), LEVEL, mean_deviates=False))
    assert not is_too_weak(LayerShare(layer=P.CAUSTIC, channel="red", share=0.01, acts_on=0.01))
    # Noise as wide as the excess leaves none of it sure.
    noisy = layer_shares(light(1.0, 0.5, 1.0, caustic=0.01), LEVEL, mean_deviates=True)
    assert [each.needed for each in noisy] == [None]
