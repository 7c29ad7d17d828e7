"""The numbers of ``references/analytic.yaml`` are those that independent code computes, and every one of them is."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from mpmath import mp, mpf, radians, tan, workdps
from ruamel.yaml import YAML

from tests.closed_forms import area_lights, ball_lens, beer, cards, prisms, profiles, rough, slabs
from tests.closed_forms.shadows import Penumbra
from tests.closed_forms.truths import CONSTANTS, CROWN, DROP, EDGE, OUTER, RINGS, SCENES
from vitrail.judge.references import read_scene_truth
from vitrail.metrics.by_phenomenon import BY_PHENOMENON
from vitrail.scene.load import load

ROOT = Path(__file__).resolve().parents[2]
DIGITS = 1e-11
"""The file holds twelve digits."""


@pytest.fixture(autouse=True)
def thirty_digits():
    with workdps(30):
        yield


@pytest.fixture(scope="module")
def written():
    return YAML(typ="safe").load((ROOT / "references" / "analytic.yaml").read_text())


@pytest.mark.parametrize("key", list(SCENES), ids="-".join)
def test_a_scenes_number_is_the_computed_one(written, key):
    scene, observation, metric = key
    entry = written["scenes"][scene][observation][metric]
    assert entry["value"] == pytest.approx(float(SCENES[key]()), rel=DIGITS, abs=0)
    assert entry["formula"] and entry["source"]


@pytest.mark.parametrize("name", list(CONSTANTS))
def test_a_constant_is_the_computed_one(written, name):
    assert written["constants"][name]["value"] == pytest.approx(float(CONSTANTS[name]()), rel=DIGITS)


def test_nothing_is_written_that_is_not_computed(written):
    found = {
        (scene, observation, metric)
        for scene, observations in written["scenes"].items()
        for observation, metrics in observations.items()
        for metric in metrics
        if metric not in ("context", "profile")
    }
    assert found == set(SCENES)
    assert set(written["constants"]) == set(CONSTANTS)


def test_profiles_are_the_computed_ones(written):
    """They are for people to see, and held to seven digits; of the caustic a few places are computed again."""
    found = {
        (scene, name): entry["profile"]
        for scene, observations in written["scenes"].items()
        for name, entry in observations.items()
        if "profile" in entry
    }
    assert set(found) == set(profiles.PROFILES)
    spectrum = found["prism_screen", "spectrum"]
    assert ("v", spectrum["positions_m"], spectrum["values"]) == (
        "v",
        *(pytest.approx(each, rel=1e-7, abs=1e-8) for each in profiles.spectrum_profile()[1:]),
    )
    caustic = found["ball_lens", "caustic"]
    curve = dict(zip(caustic["positions_m"], caustic["values"], strict=True))
    assert list(curve) == pytest.approx([float(u) for u in profiles.CAUSTIC_AT])
    with workdps(15):
        for u in (0, 0.5, -1.1):
            assert curve[u] == pytest.approx(float(profiles.across_the_caustic(u)), rel=1e-7)


def test_a_profile_holds_the_light_that_enters():
    """The stripes of the spectrum hold all light of the beam, whatever the index of each."""
    _, places, values = profiles.spectrum_profile()
    light = sum((b - a) * (y + z) / 2 for a, b, y, z in zip(places, places[1:], values, values[1:], strict=False))
    bright = 0.2126 + 0.7152 + 0.0722
    assert light == pytest.approx(0.8 / math.pi * 20 * 0.04 * bright, rel=1e-4)


def test_the_context_of_the_ball_lens_is_that_of_the_computation(written):
    context = written["scenes"]["ball_lens"]["caustic"]["context"]
    assert context["annulus_edges_m"] == [float(edge) for edge in RINGS]
    assert context["outer_radius_m"] == float(OUTER)


def test_the_judge_can_read_every_scene(written):
    for name in written["scenes"]:
        (path,) = (ROOT / "scenes").rglob(f"{name}.yaml")
        scene = load(path).scene
        truth = read_scene_truth(ROOT / "references", name, scene)
        for observation in scene.observe:
            assert truth.of(observation.name), f"{name} observes {observation.name} without a truth"
            assert observation.phenomenon in BY_PHENOMENON


def assert_same(first, second, digits=20):
    assert abs(mpf(first) - mpf(second)) < mpf(10) ** -digits * max(1, abs(mpf(second)))


def test_quadrature_of_the_lamp_is_its_solid_angle():
    half = mpf("0.5")
    assert_same(cards.lamplit_mean_by_quadrature("0.18", 10, 2, half), cards.lamplit_mean("0.18", 10, 2, half))


def test_following_the_bounces_is_the_closed_slab():
    for degrees in (0, 30, 60, 80):
        assert_same(slabs.slab_by_bounces(CROWN, degrees), slabs.slab(CROWN, degrees))


def test_adding_layers_is_multiplying_matrices_is_stokes():
    face = slabs.fresnel(CROWN, 30)
    assert_same(slabs.slab(CROWN, 30, panes=5), slabs.stack_by_matrices(CROWN, 30, 5))
    assert_same(slabs.slab(CROWN, 30, panes=5), (1 - face) / (1 + 9 * face))


def test_the_jacobian_integrates_to_the_flux_that_entered():
    assert_same(ball_lens.flux_by_quadrature(OUTER, CROWN, DROP), ball_lens.flux_within(OUTER, CROWN, DROP), 12)
    # Near the axis the lens is a simple one: focus 1.5 from the centre, so 9 times the sun on the plane at 2.
    assert ball_lens.irradiance_gain(mpf("1e-4"), CROWN, DROP) == pytest.approx(9, abs=1e-5)


def test_the_ball_lens_has_the_published_annuli():
    # [O 1.6], to the digits printed there: half of a unit in the last is 3.5e-4 at worst.
    published = (8.504, 7.014, 4.407, 2.433, 1.440, 0.7454, 0.3593)
    for k, truth in enumerate(published):
        assert float(ball_lens.ring_gain(RINGS[k], RINGS[k + 1], CROWN, DROP)) == pytest.approx(truth, rel=4e-4)


def test_half_of_the_flux_is_within_r50():
    radius = ball_lens.radius_of_share(mpf("0.5"), OUTER, CROWN, DROP)
    half = ball_lens.flux_within(OUTER, CROWN, DROP) / 2
    assert_same(ball_lens.flux_within(radius, CROWN, DROP), half, 15)


def test_the_least_deviation_is_where_it_stands_still():
    for index in ("1.6", "1.696"):
        assert_same(prisms.least_deviation_by_search_deg(mpf(index), 60), prisms.least_deviation_deg(mpf(index), 60))


def test_a_ray_followed_to_the_screen_is_turned_by_the_deviation():
    # Between two screens one metre apart the ray falls by the tangent of its angle.
    for index in ("1.6", "1.696"):
        near, far = (prisms.screen_height(mpf(index), 60, 55, mpf(x)) for x in (2, 3))
        assert_same(near - far, tan(radians(prisms.deviation_deg(mpf(index), 60, 55) - 25)))


def test_the_wedge_is_its_integral():
    edges = (mpf("0.1"), mpf("0.9"))
    assert_same(beer.wedge_mean_by_quadrature(4, mpf("0.5"), *edges), beer.wedge_mean(4, mpf("0.5"), *edges))
    film = (("1", "1.33", "1.5"), "0.5", mpf("0.5"))
    assert_same(beer.absorbing_film_way_by_way(*film), beer.absorbing_film(*film))


def test_the_penumbra_is_nearly_that_of_similar_triangles():
    # 0.8 of 0.2 m * 0.5 / 1.5; the cosines over the penumbra take off less than a hundredth.
    assert EDGE.width() == pytest.approx(0.8 * 0.2 / 3, rel=0.01)
    assert EDGE.crossing(0.5) == pytest.approx(0.0, abs=0.002 * 0.2)
    assert EDGE.irradiance(-0.05) == 0
    # Out of every shadow: the rectangle's form factor, here averaged over a patch a tenth of its height wide.
    whole = float(area_lights.rectangle_irradiance(1, mpf("0.1"), mpf("0.1"), 2))
    assert Penumbra(lamp=0.1, height=2.0, edge=0.5, half=1e-6).irradiance(1.0 / 3) < whole
    assert Penumbra(lamp=0.1, height=2.0, edge=1e-9, half=1e-6).irradiance(1e-6) == pytest.approx(whole, rel=1e-6)


def test_rainbows_are_where_everybody_sees_them():
    assert float(prisms.rainbow_deg(mpf("1.333"), 1)) == pytest.approx(42, abs=0.5)
    assert float(prisms.rainbow_deg(mpf("1.333"), 2)) == pytest.approx(51, abs=0.5)


def test_form_factors_are_their_integrals():
    half, third, two = mpf("0.5"), mpf("0.3"), mpf(2)
    aside = mpf("0.3")
    assert_same(
        area_lights.disc_irradiance_aside_by_quadrature(1, half, two, aside),
        area_lights.disc_irradiance_aside(1, half, two, aside),
        15,
    )
    assert_same(area_lights.disc_irradiance_by_quadrature(1, half, two), area_lights.disc_irradiance(1, half, two))
    assert_same(
        area_lights.rectangle_irradiance_by_quadrature(1, half, third, two),
        area_lights.rectangle_irradiance(1, half, third, two),
    )


@pytest.mark.parametrize("roughness", ["0.1", "0.5", "1"])
def test_the_deflection_of_equation_8_is_its_definition(roughness):
    amount = mpf(roughness)
    reach = amount / (2 - amount)
    for share in ("0.1", "0.5", "0.9"):
        x = reach * mpf(share)
        assert_same(rough.below_by_quadrature(x, amount), rough.below(x, amount), 10)
    assert_same(rough.mean_square_tangent_by_quadrature(amount), rough.mean_square_tangent(amount), 8)


def test_equation_8_has_the_published_percentiles():
    # [O 1.3]: median and 95 % of the deflection for lambda = .5.
    assert float(rough.quantile_deg(mpf("0.5"), mpf("0.5"))) == pytest.approx(5.8844, abs=5e-5)
    assert float(rough.quantile_deg(mpf("0.95"), mpf("0.5"))) == pytest.approx(15.5333, abs=5e-5)


def test_working_digits_are_those_of_this_file():
    assert mp.dps == 30
