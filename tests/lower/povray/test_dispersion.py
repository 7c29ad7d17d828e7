"""Dispersion in the real POV-Ray: slices exact to the noise, its own law within the error of its fit."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, Rendered, lowered, rendered, scene
from vitrail.optics.bands import band_model

pytestmark = pytest.mark.povray

APEX = math.radians(60)
LIT = "transport: {bands: %s}"
INCIDENCE = math.radians(50)
SCREEN = 4.0


def deviation(index: float) -> float:
    """Of a ray through a prism of 60 degrees, met at INCIDENCE."""
    inside = math.asin(math.sin(INCIDENCE) / index)
    return INCIDENCE + math.asin(index * math.sin(APEX - inside)) - APEX


def spectrum(glass: str, bands: str, **settings: object) -> Rendered:
    """A narrow beam through a prism onto a screen that faces the light of index 1.648, SCREEN away from the prism.

    The beam meets the left face in its middle. Directions turn downwards, from +x on.
    """
    tilt = INCIDENCE - APEX / 2
    beam = (math.cos(tilt), math.sin(tilt))
    entry = (-math.sin(APEX / 2) / 2, math.cos(APEX / 2) * (2 / 3 - 1 / 2))
    lamp = (entry[0] - beam[0], entry[1] - beam[1])
    across = (-beam[1] * 0.01, beam[0] * 0.01)
    middle = tilt - deviation(1.648)
    center = (SCREEN * math.cos(middle), SCREEN * math.sin(middle))
    up = (-math.sin(middle) * 0.7, math.cos(middle) * 0.7)
    eye = (center[0] - 0.3 * math.cos(middle), center[1] - 0.3 * math.sin(middle))
    screen = f"center: [{center[0]}, {center[1]}, 0], u: [0, 0, 0.5], v: [{up[0]}, {up[1]}, 0]"
    objects = f"""
    - {{name: screen, rectangle: {{{screen}}}, material: white}}
    - {{name: prism, prism: {{apex_deg: 60, side: 1, height: 1}}, material: glass}}
    """
    # The lamp shines along u x v, so u lies along the beam's normal and v along the prism.
    slit = f"center: [{lamp[0]}, {lamp[1]}, 0], u: [{across[0]}, {across[1]}, 0], v: [0, 0, 0.2]"
    light = f"- {{name: lamp, area: {{rectangle: {{{slit}}}, collimated: true, irradiance: 30}}}}"
    camera = (
        f"camera: {{kind: orthographic, position: [{eye[0]}, {eye[1]}, 0],"
        f" look_at: [{center[0]}, {center[1]}, 0], up: [{up[0]}, {up[1]}, 0], height: 1.4}}"
    )
    loaded = scene(
        f"white: {{diffuse: 0.8}}\nglass: {{transmission: 1, {glass}}}",
        objects,
        light,
        camera,
        "image: {width: 20, height: 280}",
        LIT % bands,
    )
    return rendered(loaded, photons=200_000, gather_radius_m=0.02, **settings)


def centroids(seen: Rendered) -> np.ndarray:
    """Height on the screen of each channel's light, metres, upwards."""
    profile = seen.image.radiance.mean(axis=1)
    height = (140 - (np.arange(280) + 0.5)) * 0.005
    return (profile * height[:, None]).sum(axis=0) / profile.sum(axis=0)


def landing(index: float) -> float:
    """Height on the screen at which a ray through the middle of the left face arrives, by plane geometry."""
    tilt = INCIDENCE - APEX / 2
    middle = tilt - deviation(1.648)
    entry = np.array([-math.sin(APEX / 2) / 2, math.cos(APEX / 2) * (2 / 3 - 1 / 2)])
    # Refract at the left face, whose outward normal points to 150 degrees.
    inside = math.asin(math.sin(INCIDENCE) / index)
    direction = APEX / 2 * -1 + inside
    way = np.array([math.cos(direction), math.sin(direction)])
    # Meet the right face, through the apex, with its outward normal at 30 degrees.
    apex, normal = np.array([0, math.cos(APEX / 2) * 2 / 3]), np.array([math.cos(APEX / 2), math.sin(APEX / 2)])
    point = entry + way * ((apex - entry) @ normal) / (way @ normal)
    out = tilt - deviation(index)
    way = np.array([math.cos(out), math.sin(out)])
    axis, up = np.array([math.cos(middle), math.sin(middle)]), np.array([-math.sin(middle), math.cos(middle)])
    point = point + way * ((SCREEN * axis - point) @ axis) / (way @ axis)
    return float(point @ up)


def expected(indices: list[float], weights: list[tuple[float, float, float]]) -> np.ndarray:
    heights = np.array([landing(index) for index in indices])
    share = np.array(weights)
    return (share * heights[:, None]).sum(axis=0) / share.sum(axis=0)


def index_residual(seen: Rendered) -> float:
    return next(each.residual for each in seen.lowered.certificate.entries if each.unit == "index")


def test_slices_put_every_band_where_snell_does() -> None:
    """The paper's figure 8: 1.600, 1.632, 1.664, 1.696. 1 mm at 4 m: a fifth of a pixel, some 3000 photons a band."""
    seen = spectrum("ior: 1.6, dispersion: 0.032", "paper")
    assert seen.lowered.mode.name == "slices" and len(seen.lowered.runs) == 8
    bands = band_model("paper").bands
    wanted = expected([1.6, 1.632, 1.664, 1.696], [band.weight for band in bands])
    assert centroids(seen) == pytest.approx(wanted, abs=1e-3)
    assert index_residual(seen) == 0


def test_the_native_law_stays_within_its_certificate() -> None:
    """POV-Ray's own four bands: outer and middle indices off by the fit's residual, which moves the light by dD/dn."""
    seen = spectrum("ior: 1.6, dispersion: 0.032", "povray", reference_mode="native")
    assert "dispersion_samples 4" in seen.lowered.runs[0].sdl
    bands = band_model("povray").bands
    wanted = expected([1.6, 1.632, 1.664, 1.696], [band.weight for band in bands])
    residual = index_residual(seen)
    assert 0 < residual < 2e-3
    moved = abs(landing(1.65 + residual) - landing(1.65))
    assert centroids(seen) == pytest.approx(wanted, abs=moved + 2e-3)


def test_a_glass_without_dispersion_runs_one_band() -> None:
    made = lowered(
        scene(
            "panel: {emission: 1}\nglass: {transmission: 1, ior: 1.5}",
            """
            - {name: panel, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: panel}
            - {name: slab, box: {min: [-4, 0.5, -4], max: [4, 0.9, 4]}, material: glass}
            """,
            lights="",
        )
    )
    assert len(made.runs) == 2 and made.mode.name == "native"


def test_white_light_stays_white_where_nothing_is_spread() -> None:
    """A dispersive slab at normal incidence, in slices: the bands add up to the panel."""
    seen = rendered(
        scene(
            "panel: {emission: 1}\nglass: {transmission: 1, ior: 1.6, dispersion: 0.03}",
            """
            - {name: panel, rectangle: {center: [0, 0, 0], u: [0.45, 0, 0], v: [0, 0, -0.45]}, material: panel}
            - {name: slab, box: {min: [-4, 0.1, -4], max: [4, 0.3, 4]}, rotate_deg: [0, 0, 35], material: glass}
            """,
            lights="",
            camera="camera: {kind: orthographic, position: [0, 4, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 1}",
        )
    )
    assert len(seen.lowered.mode.bands) > 1
    assert seen.image.radiance[16, 16] == pytest.approx(1, rel=HALF_FLOAT)


def test_a_ball_of_many_bands_is_invisible_in_a_white_furnace() -> None:
    """Sixteen wide bands stand for forty. By POV-Ray's own dispersion red light never leaves the rim."""
    seen = rendered(
        scene(
            "glass: {transmission: 1, ior: 1.65, dispersion: {abbe: 25}, fresnel: true}",
            "- {name: ball, sphere: {center: [0, 0, 0], radius: 0.5}, material: glass}",
            lights="- {name: sky, environment: {radiance: 1}}",
            image="image: {width: 20, height: 20}",
            more="transport: {bands: {spectral: 40}, max_reflections: 50, max_transmissions: 100}",
        )
    )
    assert seen.lowered.mode.name == "slices" and len(seen.lowered.mode.bands) == 16
    assert seen.image.radiance == pytest.approx(1, rel=1e-3)


def test_wide_bands_keep_their_distance_from_the_bands_they_stand_for() -> None:
    """Of 32 bands of 10.9 nm in 16: each is 5.5 nm from the middle of its wide one, most of the index in violet."""
    many = scene(
        "glass: {transmission: 1, ior: 1.6, dispersion: 0.0875}",
        "- {name: ball, sphere: {center: [0, 0, 0], radius: 0.5}, material: glass}",
        more="transport: {bands: {spectral: 32}}",
    )
    made = lowered(many)
    # The index rises by 0.0875 for every 87.5 nm, so by 1e-3 for each nanometre.
    entry = next(each for each in made.certificate.entries if each.unit == "index")
    assert entry.residual == pytest.approx(350 / 64 * 1e-3, rel=1e-9)
