"""What is bought for a number in doubt, in which order, and at what price."""

from __future__ import annotations

import math

import pytest

from vitrail.base.changed import changed
from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import Comparison, ObservationResult, Pair, PatchRecord, TolerancePart, Verdict
from vitrail.judge.noise_record import NoiseRecord, learnt
from vitrail.judge.observe import Observed
from vitrail.judge.purchase import Purchase, price_score
from vitrail.judge.records import EngineRun, SceneResult, Status
from vitrail.judge.verdict import Measured, Noise, decide, overall
from vitrail.judge.view_record import ViewRecord
from vitrail.pipeline.basket import FINER, LEAST, MOST_PHOTONS, SAFETY, cheapest, levels
from vitrail.pipeline.look_again import with_look
from vitrail.pipeline.more_samples import offer, purchases
from vitrail.pipeline.prices import paid_s, price_s
from vitrail.pipeline.scene_run import SceneRun
from vitrail.scene.model import Observation, Patch


def compared(value: float, error: float) -> Comparison:
    part = TolerancePart(source="threshold", amount=0.01, reason="for this test")
    return decide(Measured(Pair.TRACER_POVRAY, "flux", "1", value, 1.0, Noise(error)), [part], 0.95)


def observation(name: str, *comparisons: Comparison, photons: float = 0.0, view: bool = True) -> ObservationResult:
    """An observation in a view of its own, ``photons`` being their share in its noise."""
    verdict = overall(entry.verdict for entry in comparisons)
    eye = {"position": (0, 1, 0), "look_at": (0, 0, 0), "up": (0, 0, 1)}
    return ObservationResult(
        name=name,
        phenomenon=Phenomenon.CAUSTIC,
        patch=PatchRecord(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1)),
        view=ViewRecord(name=name, kind="perspective", **eye, width=9, height=9, samples=4) if view else None,
        noise=(NoiseRecord(side="povray", photons=photons, edges=(1 - photons) / 2, rays=(1 - photons) / 2),),
        comparisons=comparisons,
        verdict=verdict or Verdict.INCONCLUSIVE,
    )


def engine(photons_s: float, **views_s: float) -> EngineRun:
    """An engine whose photons and views took so many CPU seconds; it gathers apart from its camera, and never."""
    views = [{"name": name, "cpu_s": {"camera": cpu_s, "gather": 1e-9}} for name, cpu_s in views_s.items()]
    return EngineRun(engine="x", version="1", record={"cpu_s": {"photon_pass": photons_s}, "views": views})


def scene(*observations: ObservationResult, engines: tuple[EngineRun, ...], name: str = "s", photons: int = 1000):
    return SceneResult(
        name=name,
        title="",
        source="",
        status=Status.JUDGED,
        settings={"photons": photons, "samples": 4},
        observations=observations,
        verdict=overall(entry.verdict for entry in observations),
        engines=engines,
        exit_code=5,
    )


OPEN = compared(1.0, 0.015)
"""A number that needs a variance (1.96 * 0.015 / 0.01)^2 = 8.6 times smaller."""
FACTOR = SAFETY * (1.959964 * 0.015 / 0.01) ** 2
DEAR = compared(1.0, 0.1)
"""One that needs 44 times as much."""


SPOT = Observation(name="spot", phenomenon=Phenomenon.CAUSTIC, patch=Patch(center=(0, 0, 0), u=(1, 0, 0), v=(0, 0, 1)))


def test_a_number_says_how_much_smaller_its_variance_must_be() -> None:
    found = levels(scene(observation("spot", DEAR, OPEN, compared(1.0, 0.001)), engines=(engine(1.0, spot=1.0),)))
    assert found == {"spot": [pytest.approx(FACTOR), pytest.approx(400 / 9 * FACTOR)]}
    nearly = observation("spot", compared(1.0, 0.00515))
    assert levels(scene(nearly, engines=()))["spot"] == [LEAST]
    # On the very edge no number of samples decides.
    assert levels(scene(observation("spot", compared(1.01, 0.001)), engines=())) == {}


def test_only_the_cause_of_the_noise_is_bought() -> None:
    engines = (engine(1.0, spot=1.0),)
    pixels = cheapest(scene(observation("spot", OPEN, photons=0.0), engines=engines), {"spot": FACTOR})
    assert pixels is not None and pixels.photons == 1 and pixels.samples["spot"] == pytest.approx(FACTOR)
    photons = cheapest(scene(observation("spot", OPEN, photons=1.0), engines=engines), {"spot": FACTOR})
    assert photons is not None and photons.samples["spot"] == 1
    assert FACTOR <= photons.photons <= FACTOR * FINER


def test_two_causes_are_paid_where_they_are_cheapest() -> None:
    """With w / p + (1 - w) / s = 1 / f and the price a p + b s the least is at s / p = sqrt((1 - w) a / (w b))."""
    for photons_s, view_s in ((1.0, 1.0), (0.05, 5.0), (5.0, 0.05)):
        doubtful = scene(observation("spot", OPEN, photons=0.5), engines=(engine(photons_s, spot=view_s),))
        found = cheapest(doubtful, {"spot": FACTOR})
        ratio = math.sqrt(photons_s / view_s)
        best = FACTOR * 0.5 * (1 + 1 / ratio) * photons_s + FACTOR * 0.5 * (1 + ratio) * view_s
        assert found is not None
        # Photons are tried in steps of 19 %, of which the price feels a half at most.
        assert best <= found.price_s <= 1.1 * best
        assert 0.5 / found.photons + 0.5 / found.samples["spot"] <= 1 / FACTOR * (1 + 1e-12)


def test_samples_that_a_scene_fixes_are_not_raised() -> None:
    engines = (engine(1.0, spot=1.0),)
    photons = scene(observation("spot", OPEN, photons=1.0), engines=engines)
    assert cheapest(photons, {"spot": FACTOR}, fixed_samples=True) is not None
    pixels = scene(observation("spot", OPEN, photons=0.5), engines=engines)
    assert cheapest(pixels, {"spot": FACTOR}, fixed_samples=True) is None


def test_more_photons_than_a_machine_holds_are_never_bought() -> None:
    doubtful = scene(observation("spot", OPEN, photons=1.0), engines=(engine(1.0, spot=1.0),), photons=MOST_PHOTONS)
    assert cheapest(doubtful, {"spot": FACTOR}) is None
    wish = offer(doubtful, 60.0, 60.0)
    assert wish is not None and not wish.affordable and "more than a machine holds" in wish.reason


def test_a_bill_holds_what_was_priced() -> None:
    """Ordering POV-Ray's photons is our work and in no engine's total: a look pays for it as its price did."""
    record = {"cpu_s": {"total": 5.0, "photon_pass": 2.0, "photon_order": 3.0, "camera": 3.0}}
    run = EngineRun(engine="povray", version="1", cpu_s=5.0, record=record)
    assert paid_s([run, run]) == 16.0
    doubtful = scene(observation("spot", OPEN), engines=(run,))
    bought = Purchase(samples={"spot": 4}, photons=1000, numbers=1, predicted_s=price_s([run], 1.0, {"spot": 1.0}))
    found = with_look(SceneRun(doubtful), SceneRun(doubtful), bought).record.purchases[0]
    assert found.paid_s == found.predicted_s == 8.0


def test_a_price_counts_photons_once_and_every_view_that_is_looked_at() -> None:
    run = engine(2.0, spot=1.0, wall=10.0)
    assert price_s([run, run], 3.0, {"spot": 4.0}) == pytest.approx(2 * (2 * 3 + 4))
    gathers = EngineRun(
        engine="x",
        version="1",
        photons_stored=9,
        record={"cpu_s": {}, "views": [{"name": "spot", "cpu_s": {"camera": 1.0, "gather": 2.0, "total": 3.5}}]},
    )
    # Eight times the photons are four times as many in a disc; half a second is the start of the program.
    assert price_s([gathers], 8.0, {"spot": 2.0}) == pytest.approx(0.5 + 2 * (1 + 2 * 4))
    plain = EngineRun(engine="x", version="1", record={"cpu_s": {"camera": 3.0, "gather": 0.0}})
    assert price_s([plain], 1.0, {"": 2.0}) == pytest.approx(6.0)


def test_the_cheapest_decisions_of_all_scenes_come_first() -> None:
    cheap = scene(observation("spot", OPEN, DEAR), engines=(engine(0.0, spot=1.0),), name="cheap")
    dear = scene(observation("spot", OPEN), engines=(engine(0.0, spot=20.0),), name="dear")
    sure = scene(observation("spot", compared(1.0, 0.001)), engines=(engine(0.0, spot=1.0),), name="sure")
    one = purchases([dear, cheap, sure], 12.0)
    assert list(one) == ["cheap"] and one["cheap"].numbers == 1
    assert one["cheap"].samples == {"spot": math.ceil(4 * FACTOR)}
    assert one["cheap"].predicted_s == pytest.approx(FACTOR)
    # What is left buys the next number of the one, or the first of the other: 20 f is less than 43 f more.
    two = purchases([dear, cheap, sure], 22 * FACTOR)
    assert {name: each.numbers for name, each in two.items()} == {"cheap": 1, "dear": 1}
    every = purchases([dear, cheap, sure], 1000 * FACTOR)
    assert {name: each.numbers for name, each in every.items()} == {"cheap": 2, "dear": 1}
    assert purchases([dear, cheap, sure], 1.0) == {}


def test_views_of_a_scene_share_the_photons_that_are_bought() -> None:
    both = [observation(name, OPEN, photons=1.0) for name in ("spot", "wall")]
    found = purchases([scene(*both, engines=(engine(10.0, spot=1.0, wall=1.0),))], 1e6)["s"]
    assert found.numbers == 2 and set(found.samples) == {"spot", "wall"}
    assert found.predicted_s < 10 * FACTOR * FINER + 3


def test_what_is_too_dear_is_priced_and_not_bought() -> None:
    doubtful = scene(observation("spot", OPEN), engines=(engine(0.0, spot=1.0),))
    rich, poor = offer(doubtful, FACTOR + 1, 60.0), offer(doubtful, FACTOR - 1, 60.0)
    assert rich is not None and rich.affordable and rich.cpu_s == pytest.approx(FACTOR)
    assert poor is not None and not poor.affordable
    assert "to decide 1 of 1 open numbers takes 1 times the photons and 11 in spot times the samples" in poor.reason
    assert "about 11 CPU s more" in poor.reason
    assert "of the 60 CPU s of this run" in poor.reason


def test_what_no_number_of_samples_decides_says_so() -> None:
    edge = offer(scene(observation("spot", compared(1.01, 0.001)), engines=()), 60.0, 60.0)
    assert edge is not None and not edge.affordable and edge.factor is None and "cannot decide" in edge.reason
    assert offer(scene(observation("spot", compared(1.0, 0.001)), engines=()), 60.0, 60.0) is None


def test_prices_are_scored_by_a_factor_of_two() -> None:
    def paid(seconds: float | None) -> Purchase:
        return Purchase(samples={"spot": 8}, photons=0, numbers=1, predicted_s=10.0, paid_s=seconds)

    score = price_score([paid(5.0), paid(20.0), paid(20.1), paid(4.9), paid(None)])
    assert (score.bought, score.close, score.predicted_s, score.paid_s) == (4, 2, 40.0, 50.0)


def test_what_a_look_did_not_lessen_is_not_bought_again() -> None:
    """Four times the photons left the noise of a peak as it was: it is of samples, wherever in the picture it lies."""
    before = NoiseRecord(side="povray", photons=0.9, edges=0.1, rays=0.0)
    assert learnt(before, before, 4.0, 1.0).photons == 0
    assert learnt(before, before, 4.0, 1.0).edges == 1
    lessened = changed(before, photons=0.225, edges=0.1)
    assert learnt(before, lessened, 4.0, 1.0).photons == pytest.approx(0.225)
    # Samples alone: what stayed is of photons, though it lies where edges are.
    stayed = changed(before, photons=0.0, edges=0.9)
    assert learnt(before, stayed, 1.0, 8.0).photons == pytest.approx((8 * 0.9 - 1) / 7)
    # Both grew alike, or nothing is known: the picture alone says.
    assert learnt(before, stayed, 4.0, 4.0) is stayed
    silent = changed(before, photons=0.0, edges=0.0)
    assert learnt(silent, stayed, 4.0, 1.0) is stayed


def test_another_look_keeps_what_it_has_shown() -> None:
    """A purchase of photons that changed nothing: the causes in the record say samples from then on."""
    doubtful = observation("spot", OPEN, photons=1.0)
    first = scene(doubtful, engines=())
    seen = Observed(
        observation=SPOT,
        patch=doubtful.patch,
        half_edge_m=1.0,
        measured=(),
        truths=(),
        profiles=(),
        unmeasured=(),
        view=doubtful.view,
        noise=doubtful.noise,
    )
    bought = Purchase(samples={"spot": 4}, photons=4000, numbers=1, predicted_s=1.0)
    found = with_look(SceneRun(first, (seen,)), SceneRun(first, (seen,)), bought)
    assert found.observed[0].noise[0].photons == 0
    # The next look has as many photons as the last one: nothing more is learnt of them.
    again = with_look(found, SceneRun(first, (seen,)), bought)
    assert again.observed[0].noise[0].photons == 1
