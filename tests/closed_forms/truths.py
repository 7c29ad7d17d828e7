"""Which code computes which number of ``references/analytic.yaml``: by scene, observation and metric, or by name."""

from __future__ import annotations

from collections.abc import Callable

from mpmath import mpf, pi

from tests.closed_forms import area_lights, ball_lens, beer, cards, conformance, prisms, rough, slabs
from tests.closed_forms.shadows import Penumbra

CROWN = mpf("1.5")
DROP = mpf(2)
RINGS = tuple(mpf(x) for x in ("0", "0.05", "0.1", "0.2", "0.3", "0.4", "0.6", "0.8"))
OUTER = mpf("0.9")
"""Of the ball lens: index, plane below the centre in radii, annuli, and the circle inside the ball's shadow."""

FLOOR = mpf("0.8")
"""Radiance of that floor in full sun: diffuse 0.8, irradiance pi."""

CHANNELS = ("red", "green", "blue")
Computed = Callable[[], mpf]


def _coloured(scene: str, observation: str, family: str, values: tuple[Computed, ...]) -> dict:
    return {(scene, observation, f"{family}.{c}"): value for c, value in zip(CHANNELS, values, strict=True)}


def _ring(k: int) -> Computed:
    return lambda: FLOOR * ball_lens.ring_gain(RINGS[k], RINGS[k + 1], CROWN, DROP)


def _card(diffuse: str) -> Computed:
    return lambda: cards.sunlit(diffuse, 3, mpf("0.8"))


def _overcast(zenith: str, diffuse: str) -> Computed:
    return lambda: mpf(diffuse) / pi * mpf(zenith) * cards.overcast_irradiance(rows=32)


def _overcast_row(zenith: str, share: str) -> Computed:
    return lambda: mpf(share) * mpf(zenith) * cards.overcast_row(5, rows=32)


def _lamp(diffuse: str) -> Computed:
    return lambda: cards.lamplit_mean(diffuse, 10, 2, mpf("0.5"))


def _floor(x: str, z: str, half_edge: str) -> Computed:
    return lambda: conformance.floor_under_sun_and_lamp(x, z, half_edge)


def _pane(share: str) -> Computed:
    return lambda: slabs.weighted_pane(share)


def _tumbler(absorption_per_m: str) -> Computed:
    return lambda: beer.absorbing_film(("1", "1.33", "1.5"), absorption_per_m, mpf("0.5")) / CROWN**2


def _slab(degrees: int) -> Computed:
    return lambda: slabs.slab(CROWN, degrees)


def _ball_flux() -> mpf:
    return FLOOR * ball_lens.flux_within(OUTER, CROWN, DROP)


def _spot(diffuse: str) -> Computed:
    return lambda: cards.lamplit_mean(diffuse, 10, 2, mpf("0.4"))


def _disc(diffuse: str) -> Computed:
    return lambda: mpf(diffuse) / pi * area_lights.disc_irradiance_over_patch(5, mpf("0.5"), 1, mpf("0.02"))


def _ambient(diffuse: str, irradiance: int) -> Computed:
    return lambda: mpf(diffuse) * irradiance / pi


def _wedge(absorption: int) -> Computed:
    return lambda: beer.wedge_mean(absorption, mpf("0.5"), mpf("0.1"), mpf("0.9"))


def _ring_of_matter(absorption: int) -> Computed:
    return lambda: beer.torus_mean(absorption, ("1", "0.4"), ("0.2", "0.05"))


def _mirrored(reflection: str) -> Computed:
    return lambda: cards.half_and_half(reflection, 1, mpf("0.25"))


def _on_screen(name: str) -> mpf:
    """Along v of prism_screen's patch, whose centre is at y = -1; blue is its own band, the others share two."""
    height = {band: prisms.screen_height(mpf(n), 60, 55, mpf("2.5")) + 1 for band, n in FLINT.items()}
    shared = {"red": ("red", "yellow"), "green": ("yellow", "green"), "blue": ("blue",)}
    if name.startswith("band_"):
        return height[name.removeprefix("band_")]
    return sum(height[band] for band in shared[name]) / len(shared[name])


FLINT = {"red": "1.6", "yellow": "1.632", "green": "1.664", "blue": "1.696"}
PLACES = (*(f"band_{band}" for band in FLINT), *CHANNELS)
EDGE = Penumbra(lamp=0.1, height=2.0, edge=0.5, half=0.1)
WALL = ("0.9", "0.6", "0.3")
GREY = ("0.18", "0.5", "0.9")
TINT = ("0.9", "0.5", "0.2")

ZENITH = ("0.85", "1", "1.2")

PANELS = {
    "near_left": ("0.9", "0.1", "0.05"),
    "near_right": ("0.1", "0.7", "0.05"),
    "far_left": ("0.05", "0.1", "0.6"),
    "far_right": ("0.5", "0.5", "0.5"),
}

SCENES: dict[tuple[str, str, str], Computed] = {
    **{
        ("camera", panel, f"mean_radiance.{channel}"): lambda emission=emission: mpf(emission)
        for panel, colours in PANELS.items()
        for channel, emission in zip(CHANNELS, colours, strict=True)
    },
    **{
        ("colour", panel, f"mean_radiance.{channel}"): lambda emission=emission: mpf(emission)
        for panel, colours in conformance.GLOWING.items()
        for channel, emission in zip(CHANNELS, colours, strict=True)
    },
    **_coloured(
        "colour", "card", "mean_radiance", tuple(lambda k=k: conformance.card_in_coloured_light(k) for k in range(3))
    ),
    **_coloured("units", "by_sun", "mean_radiance", (_floor("-0.9", "-0.4", "0.2"),) * 3),
    **_coloured("units", "below_lamp", "mean_radiance", (_floor("0.7", "0.4", "0.15"),) * 3),
    **_coloured("units", "beside_lamp", "mean_radiance", (_floor("0", "0.4", "0.15"),) * 3),
    **_coloured("grey_card_directional", "card", "mean_radiance", tuple(_card(d) for d in GREY)),
    ("grey_card_directional", "card", "tilt.u"): lambda: mpf(0),
    ("grey_card_directional", "card", "tilt.v"): lambda: mpf(0),
    ("grey_card_directional", "card", "bow"): lambda: mpf(0),
    **_coloured("grey_card_point", "card", "mean_radiance", tuple(_lamp(d) for d in GREY)),
    ("grey_card_point", "card", "tilt.u"): lambda: mpf(0),
    ("grey_card_point", "card", "tilt.v"): lambda: mpf(0),
    ("grey_card_point", "card", "bow"): lambda: cards.lamplit_bow(2, mpf("0.5")),
    **_coloured("slab_normal", "through", "mean_radiance", (_slab(0),) * 3),
    **_coloured("slab_tilted", "through", "mean_radiance", (_slab(60),) * 3),
    **_coloured("slab_clear", "through", "mean_radiance", (lambda: slabs.weighted_pane(1),) * 3),
    **_coloured("tinted_pane_seen", "through", "transmittance", tuple(_pane(t) for t in TINT)),
    **_coloured("tinted_pane_projected", "projected", "transmittance", tuple(_pane(t) for t in TINT)),
    **_coloured("grey_card_spot", "card", "mean_radiance", tuple(_spot(d) for d in GREY)),
    **_coloured("grey_card_disc", "card", "mean_radiance", tuple(_disc(d) for d in GREY)),
    **_coloured("overcast_card", "card", "mean_radiance", tuple(_overcast(z, "0.5") for z in ZENITH)),
    **_coloured("overcast_card", "sky", "mean_radiance", tuple(_overcast_row(z, "0.9") for z in ZENITH)),
    **_coloured("ambient_card", "card", "mean_radiance", tuple(_ambient(d, 2) for d in GREY)),
    **_coloured("ambient_card", "card", "indirect_radiance", tuple(_ambient(d, 1) for d in GREY)),
    **_coloured("closed_room", "wall", "mean_radiance", (lambda: 1 / pi,) * 3),
    **_coloured("closed_room", "wall", "indirect_radiance", (lambda: 1 / (2 * pi),) * 3),
    **_coloured("tumbler", "through", "mean_radiance", tuple(_tumbler(a) for a in ("0.5", "2", "8"))),
    **_coloured("turned_tumbler", "through", "mean_radiance", tuple(_tumbler(a) for a in ("0.5", "2", "8"))),
    **_coloured("absorbing_torus", "across", "mean_radiance", tuple(_ring_of_matter(a) for a in (1, 2, 4))),
    **_coloured("beer_slab", "through", "absorption", tuple(lambda a=a: mpf(a) for a in ("0.5", "2", "8"))),
    **_coloured("beer_wedge", "slope", "absorption_fit", tuple(lambda a=a: mpf(a) for a in (1, 2, 4))),
    **_coloured("beer_wedge", "slope", "mean_radiance", tuple(_wedge(a) for a in (1, 2, 4))),
    **_coloured("invisible_ball", "shadow", "transmittance", (lambda: mpf(1),) * 3),
    **_coloured("mirror", "image", "mean_radiance", tuple(_mirrored(r) for r in WALL)),
    ("mirror", "image", "edge_place.u"): lambda: mpf(0),
    **_coloured(
        "mirror_caustic", "thrown", "caustic_flux", (lambda: FLOOR / pi * 3 * FLOOR * mpf("0.9") * mpf("0.24"),) * 3
    ),
    ("mirror_caustic", "thrown", "centroid.u"): lambda: mpf(0),
    ("mirror_caustic", "thrown", "centroid.v"): lambda: mpf(0),
    ("penumbra", "edge", "penumbra_width"): lambda: mpf(EDGE.width()),
    ("penumbra", "edge", "shadow_edge"): lambda: mpf(EDGE.crossing(0.5)),
    ("penumbra", "edge", "shadow_depth"): lambda: mpf(0),
    **{("prism_screen", "spectrum", f"place.{n}"): lambda n=n: _on_screen(n) for n in PLACES},
    ("prism_screen", "spectrum", "spread"): lambda: _on_screen("blue") - _on_screen("red"),
    ("prism_screen", "spectrum", "colour_order"): lambda: mpf(-1),
    ("prism_screen", "spectrum", "peaks"): lambda: mpf(4),
    **_coloured("reflecting_prism", "turned", "mean_radiance", (lambda: slabs.turned_by_prism("0.9", "0.1"),) * 3),
    ("slab_shift", "edge", "edge_place.v"): lambda: slabs.apparent_shift(CROWN, 60, mpf("0.5")) - mpf("0.5"),
    **{
        ("white_furnace", name, f"furnace_deviation.{c}"): lambda: mpf(0)
        for name in ("weights", "fresnel", "mirror", "card")
        for c in CHANNELS
    },
    **{("ball_lens", "caustic", f"annulus_mean.{k}"): _ring(k) for k in range(len(RINGS) - 1)},
    **_coloured("ball_lens", "caustic", "caustic_flux", (_ball_flux,) * 3),
    ("ball_lens", "caustic", "centroid.u"): lambda: mpf(0),
    ("ball_lens", "caustic", "centroid.v"): lambda: mpf(0),
    ("ball_lens", "caustic", "r50"): lambda: ball_lens.radius_of_share(mpf("0.5"), OUTER, CROWN, DROP),
    ("ball_lens", "caustic", "r90"): lambda: ball_lens.radius_of_share(mpf("0.9"), OUTER, CROWN, DROP),
}

CONSTANTS: dict[str, Computed] = {
    "slab_reflectance_60": lambda: slabs.fresnel(CROWN, 60),
    "stack_of_five_at_30": lambda: slabs.slab(CROWN, 30, panes=5),
    "absorbing_slab_at_60": lambda: slabs.slab(CROWN, 60, depth=mpf("0.5")),
    "pane_with_paper_weights": lambda: slabs.weighted_pane("0.8", "0.1"),
    "slab_sideways_at_60": lambda: slabs.sideways(CROWN, 60, 1),
    "slab_apparent_shift_at_60": lambda: slabs.apparent_shift(CROWN, 60, 1),
    **{f"prism_60_at_55_{band}": lambda n=n: prisms.deviation_deg(mpf(n), 60, 55) for band, n in FLINT.items()},
    **{f"prism_60_least_{band}": lambda n=n: prisms.least_deviation_deg(mpf(n), 60) for band, n in FLINT.items()},
    "rainbow_primary": lambda: prisms.rainbow_deg(mpf("1.333"), 1),
    "rainbow_secondary": lambda: prisms.rainbow_deg(mpf("1.333"), 2),
    "disc_lamp_on_axis": lambda: area_lights.disc_irradiance(1, mpf("0.5"), 2),
    "rectangle_lamp_below_centre": lambda: area_lights.rectangle_irradiance(1, mpf("0.5"), mpf("0.3"), 2),
    "penumbra_of_a_straight_edge": lambda: area_lights.straight_penumbra_width(mpf("0.1"), 2, mpf("0.5")),
    "rough_05_mean_tangent": lambda: rough.mean_tangent(mpf("0.5")),
    "rough_05_rms_tangent": lambda: rough.mean_square_tangent(mpf("0.5")) ** mpf("0.5"),
    "rough_05_median_deg": lambda: rough.quantile_deg(mpf("0.5"), mpf("0.5")),
    "rough_05_95_percent_deg": lambda: rough.quantile_deg(mpf("0.95"), mpf("0.5")),
    "ball_lens_gain_at_02": lambda: ball_lens.irradiance_gain(mpf("0.2"), CROWN, DROP),
    "ball_lens_flux_within_09_over_pi": lambda: ball_lens.flux_within(OUTER, CROWN, DROP) / pi,
}
