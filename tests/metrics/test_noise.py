"""Intervals must hold the truth as often as they say, and the A/A floor must be what noise alone reads."""

from dataclasses import replace

import numpy as np
import pytest
from scipy import ndimage, stats

from tests.metrics.synthetic import noisy, patch_of, spot, value_of
from vitrail.base.phenomenon import Phenomenon
from vitrail.metrics.by_phenomenon import BY_PHENOMENON, measure, measure_with_intervals
from vitrail.metrics.caustic import caustic_centroid, caustic_flux, profile_correlation
from vitrail.metrics.caustic_radii import caustic_radii
from vitrail.metrics.measurement import Context, MetricError, StudentInterval
from vitrail.metrics.noise import METHOD, noise_floor, with_interval
from vitrail.metrics.noise_model import learn_noise
from vitrail.metrics.radiance import mean_radiance

pytestmark = pytest.mark.slow

CONTEXT = Context(background=(0.0, 0.0, 0.0))
TRIALS = 100


def covered(metric, name, truth, make, level=0.95, context=CONTEXT):
    """How many of TRIALS intervals hold the truth."""
    hits = 0
    for trial in range(TRIALS):
        found = next(m for m in with_interval(metric, *make(trial), context, level=level) if m.metric == name)
        hits += found.interval.low <= truth <= found.interval.high
    return hits


def assert_holds(hits, level=0.95):
    """The count must not lie below where a binomial law of that level puts 99.95 % of counts; wider is no error."""
    low = stats.binom.ppf(5e-4, TRIALS, level)
    assert hits >= low, f"{hits} of {TRIALS} intervals hold the truth, at least {low:.0f} should"


def test_the_interval_of_a_mean_is_the_textbook_one():
    flat = noisy(patch_of(lambda u, v: 1 + 0 * u * v, n_u=64, n_v=64), 0.2, seed=4)
    found = with_interval(mean_radiance, flat, None, CONTEXT, level=0.95)[0]
    # Standard error sigma / sqrt(cells), itself known to 15 % (draws and law): three of those.
    assert found.interval.standard_error == pytest.approx(0.2 / 64, rel=0.45)
    assert found.interval.method == METHOD


def test_intervals_of_a_mean_hold_the_truth():
    base = patch_of(lambda u, v: 1 + 0 * u * v, n_u=32, n_v=32)
    assert_holds(covered(mean_radiance, "mean_radiance.red", 1.0, lambda i: (noisy(base, 0.2, i), None)))


def test_intervals_of_a_flux_ratio_between_two_noisy_images_hold_the_truth():
    base = patch_of(spot(), n_u=32, n_v=32)
    sigma = 0.3 * np.sqrt(base.values.mean(axis=-1, keepdims=True))
    pair = lambda i: (noisy(base, sigma, 2 * i), noisy(base, sigma, 2 * i + 1))  # noqa: E731
    assert_holds(covered(caustic_flux, "flux_ratio.green", 1.0, pair))
    assert_holds(covered(caustic_centroid, "centroid_shift.u", 0.0, pair))


def test_intervals_of_a_nonlinear_metric_hold_the_truth():
    base = patch_of(spot(), n_u=32, n_v=32)
    sigma = 0.2 * np.sqrt(base.values.mean(axis=-1, keepdims=True))
    context = Context(background=(0.0, 0.0, 0.0), centre_m=(0.0, 0.0))
    truth = caustic_radii(base, None, context)[0].value
    assert_holds(covered(caustic_radii, "r50", truth, lambda i: (noisy(base, sigma, i), None), context=context))


def test_noise_that_is_correlated_like_a_photon_map_is_not_underrated():
    base = patch_of(lambda u, v: 1 + 0 * u * v, n_u=64, n_v=64)

    def blurred(seed):
        # Each half gets noise blurred over a disc of radius 2 cells, as photons gathered within a radius are.
        disc = np.hypot(*np.mgrid[-2:3, -2:3]) <= 2.2
        draw = np.random.default_rng(seed)
        kernel = disc / disc.sum()
        halves = []
        for _ in range(2):
            raw = draw.normal(size=(64, 64)) * np.sqrt(2)
            halves.append(base.values + ndimage.convolve(raw, kernel, mode="wrap")[..., None])
        return replace(base, values=(halves[0] + halves[1]) / 2, half_a=halves[0], half_b=halves[1])

    hits = covered(mean_radiance, "mean_radiance.red", 1.0, lambda i: (blurred(i), None))
    assert_holds(hits)


def test_the_law_of_the_noise_is_learnt_and_redrawn():
    # Counted photons: variance proportional to radiance, which spans 1 to 10 here; red and green go together.
    base = patch_of(lambda u, v: 5.5 + 4.5 * u + 0 * v, n_u=96, n_v=96)
    draw = np.random.default_rng(7)

    def half():
        grain = draw.normal(size=(96, 96, 2)) * np.sqrt(2)
        return base.values + 0.1 * np.sqrt(base.values) * grain[..., [0, 0, 1]]

    a, b = half(), half()
    rendered = replace(base, values=(a + b) / 2, half_a=a, half_b=b)
    model = learn_noise(rendered, 0.0)
    # A window of 3 cells has 113 cells of effect, so a variance is good to 13 %; the median over the patch to a few.
    assert np.median(model.deviation / (0.1 * np.sqrt(base.values))) == pytest.approx(1.0, abs=0.05)
    again = np.stack(list(model.draws(40, 0)))
    assert again.std() == pytest.approx(model.deviation.mean(), rel=0.1)
    red, green, blue = (again[..., c].ravel() for c in range(3))
    assert np.corrcoef(red, green)[0, 1] == pytest.approx(1.0, abs=0.02)
    assert np.corrcoef(red, blue)[0, 1] == pytest.approx(0.0, abs=0.05)
    np.testing.assert_array_equal(model.pair((1, 0)), model.pair((1, 0)))


def test_the_law_follows_a_caustic_narrower_than_its_window():
    # Counted photons again, in a spot of 4 cells: the window of averages is as wide, and must not flatten the peak.
    base = patch_of(spot(sigma=0.125), n_u=64, n_v=64)
    model = learn_noise(noisy(base, 0.1 * np.sqrt(base.values.mean(axis=-1, keepdims=True)), 3), 0.0)
    peak = base.values.max(axis=-1) > 0.5 * base.values.max()
    assert np.mean(model.deviation[peak] / (0.1 * np.sqrt(base.values[peak]))) == pytest.approx(1.0, abs=0.1)


def test_correlated_noise_is_redrawn_correlated():
    draw = np.random.default_rng(9)
    disc = np.hypot(*np.mgrid[-3:4, -3:4]) <= 3
    grain = [ndimage.convolve(draw.normal(size=(96, 96)), disc / disc.sum(), mode="wrap")[..., None] for _ in range(2)]
    base = patch_of(lambda u, v: 1 + 0 * u * v, n_u=96, n_v=96)
    rendered = replace(base, half_a=base.values + grain[0], half_b=base.values + grain[1])
    model = learn_noise(rendered, 3 * base.cell_u_m)
    # What matters is the mean over many cells: its variance is that of one cell times the area of the correlation.
    truth = np.std(
        [ndimage.convolve(draw.normal(size=(96, 96)), disc / disc.sum(), mode="wrap").mean() for _ in range(200)]
    )
    found = np.std([noise[..., 0].mean() for noise in model.draws(200, 0)])
    # The noise holds some 300 independent discs: its power at long lengths is known to a fifth.
    assert found == pytest.approx(truth / np.sqrt(2), rel=0.3)


def test_the_floor_is_what_an_equal_pair_reads():
    base = patch_of(spot(), n_u=32, n_v=32)
    values, floors = [], []
    for trial in range(40):
        pair = (noisy(base, 0.5, 2 * trial), noisy(base, 0.5, 2 * trial + 1))
        values.append(1 - value_of(profile_correlation(*pair, CONTEXT), "profile_correlation.u"))
        floors.append(1 - noise_floor(profile_correlation, *pair, CONTEXT)["profile_correlation.u"])
    # Means of 40 scattered values of one law: equal within three of their standard errors.
    error = np.hypot(np.std(values), np.std(floors)) / np.sqrt(40)
    assert np.mean(floors) == pytest.approx(np.mean(values), abs=3 * error)
    assert np.mean(values) > 0


def test_an_image_without_halves_says_so():
    found = with_interval(mean_radiance, patch_of(spot()), None, CONTEXT)
    assert found[0].interval is None and "no half images" in found[0].caveats[-1]
    one = with_interval(mean_radiance, noisy(patch_of(spot()), 0.1, 1), patch_of(spot()), CONTEXT)
    assert one[0].interval is not None and "one image has no halves" in one[0].caveats[-1]


def test_images_without_noise_have_intervals_of_no_width():
    base = noisy(patch_of(spot()), 0.0, 1)
    found = with_interval(caustic_flux, base, base, CONTEXT)[0]
    assert (found.interval.low, found.interval.high, found.floor) == (1.0, 1.0, 1.0)


def test_an_interval_widens_with_its_level():
    narrow = StudentInterval.about(2.0, 0.1, 10.0, 0.95, "m")
    wide = narrow.at_level(0.999)
    assert wide.low < narrow.low < 2.0 < narrow.high < wide.high
    assert narrow.high - 2.0 == pytest.approx(0.1 * 2.228139, rel=1e-6)


def test_the_same_images_give_the_same_interval():
    pair = (noisy(patch_of(spot()), 0.3, 1), noisy(patch_of(spot()), 0.3, 2))
    assert with_interval(caustic_flux, *pair, CONTEXT) == with_interval(caustic_flux, *pair, CONTEXT)


def test_every_phenomenon_has_metrics_and_no_other_name_does():
    assert set(BY_PHENOMENON) == set(Phenomenon)


@pytest.mark.parametrize("phenomenon", list(Phenomenon))
def test_every_phenomenon_can_be_measured_with_intervals(phenomenon):
    def light(u, v):
        shape = np.stack([np.exp(-((u - x) ** 2) / 0.02) + 0 * v for x in (-0.2, 0.0, 0.2)], axis=-1)
        return 0.3 + shape + 0.5 * (u > 0.6)[..., None]

    base = patch_of(light, n_u=48, n_v=24)
    ours, theirs = noisy(base, 0.01, 1), noisy(base, 0.01, 2)
    context = Context(full_radiance=(2.0, 2.0, 2.0), thickness_m=0.1)
    absolute = measure_with_intervals(phenomenon, ours, None, context)
    compared = measure_with_intervals(phenomenon, ours, theirs, context, level=0.999)
    names = [m.metric for m in absolute]
    assert absolute and compared and len(set(names)) == len(names)
    assert len({m.metric for m in compared}) == len(compared)
    assert all(m.ideal is not None for m in compared)
    # Of equal scenes with 1 % noise nothing is further from its ideal than its interval, counts apart.
    for m in compared:
        if m.interval is not None and not m.metric.startswith(("profile_correlation", "delta_e")):
            assert m.interval.low <= m.ideal <= m.interval.high, m


def test_what_one_metric_cannot_answer_is_a_caveat_on_the_others():
    flat = patch_of(lambda u, v: 1 + 0 * u * v)
    found = measure(Phenomenon.SHADOW, flat, None, Context())
    assert {m.family for m in found} == {"mean_radiance"}
    assert "penumbra: no edge" in found[0].caveats[-1]


def test_nothing_measured_is_an_error():
    dark = patch_of(lambda u, v: 0 * u * v)
    with pytest.raises(MetricError, match="caustic"):
        measure(Phenomenon.CAUSTIC, dark, dark, CONTEXT)
