"""Indices per band under every switch, and POV-Ray's law fitted to them, against [O 1.1, 1.5, 1.6]."""

from __future__ import annotations

import math

import pytest

from vitrail.optics.bands import ALL_LIGHT, PAPER, povray, spectral
from vitrail.optics.dispersion import ior_by_band, reference_ior
from vitrail.optics.dispersion_fit import fit, through_abbe
from vitrail.optics.glass import glass_named
from vitrail.optics.lines import LINE_NM
from vitrail.scene.model import Abbe, Material, Paper

PRISM = Material(transmission=1, ior=1.6, dispersion=0.032)
LITERAL = Paper()


def indices(material: Material, paper: Paper = LITERAL) -> tuple[float, ...]:
    return ior_by_band(material, PAPER.bands, paper)


def test_figure_8() -> None:
    assert indices(PRISM) == pytest.approx((1.600, 1.632, 1.664, 1.696), rel=1e-15)


# [O 1.1 items 23, 24]: red keeps sigma, or yellow, or the middle of all four; `span` spreads delta over all four.
SWITCHES = [
    ("step", "red", (1.6, 1.632, 1.664, 1.696)),
    ("step", "d_line", (1.568, 1.6, 1.632, 1.664)),
    ("step", "middle", (1.552, 1.584, 1.616, 1.648)),
    ("span", "red", (1.6, 1.6 + 0.032 / 3, 1.6 + 0.064 / 3, 1.632)),
    ("span", "middle", (1.584, 1.6 - 0.016 / 3, 1.6 + 0.016 / 3, 1.616)),
]


@pytest.mark.parametrize(("law", "reference", "expected"), SWITCHES)
def test_what_sigma_and_delta_mean(law: str, reference: str, expected: tuple[float, ...]) -> None:
    paper = Paper(dispersion=law, dispersion_reference=reference)
    assert indices(PRISM, paper) == pytest.approx(expected, rel=1e-15)


def test_prism_deviations_of_figure_8() -> None:
    """Apex 60 degrees: minimum deviations, and deviations at 55 degrees of incidence, printed to 1e-4 [O 1.5]."""
    half, incidence = math.radians(30), math.radians(55)
    for n, least, at_55 in zip(
        indices(PRISM), (46.2602, 49.3727, 52.6095, 55.9896), (46.3242, 49.3747, 52.6486, 56.2259), strict=True
    ):
        assert math.degrees(2 * math.asin(n * math.sin(half))) - 60 == pytest.approx(least, abs=6e-5)
        leaving = math.asin(n * math.sin(2 * half - math.asin(math.sin(incidence) / n)))
        assert math.degrees(incidence + leaving) - 60 == pytest.approx(at_55, abs=6e-5)


def test_the_papers_flint_reflects_its_blue() -> None:
    """Flint 1.75 + .034 i at 55 degrees: n sin r2 = 1.03 for blue, so nothing leaves [O 1.1 item 29]."""
    blue = indices(Material(transmission=1, ior=1.75, dispersion=0.034))[3]
    inside = math.radians(60) - math.asin(math.sin(math.radians(55)) / blue)
    assert blue * math.sin(inside) == pytest.approx(1.03, abs=5e-3)


def test_povray_bands_take_the_papers_indices() -> None:
    """Four equal bands carry i = 0, 1, 2, 3; more bands follow the same straight line."""
    assert ior_by_band(PRISM, povray(4).bands, LITERAL) == pytest.approx((1.6, 1.632, 1.664, 1.696), rel=1e-15)
    many = ior_by_band(PRISM, spectral(140).bands, LITERAL)
    steps = [b - a for a, b in zip(many, many[1:], strict=False)]
    assert max(steps) - min(steps) < 1e-15 * 10 and steps[0] > 0


def test_real_glass_and_abbe_per_band() -> None:
    glass = glass_named("N-SF11")
    named = Material(transmission=1, glass="N-SF11")
    assert indices(named) == tuple(glass.line(line) for line in "Cdeg")
    assert reference_ior(named) == glass.n_d
    by_abbe = indices(Material(transmission=1, ior=glass.n_d, dispersion=Abbe(abbe=glass.abbe)))
    assert by_abbe[1] == pytest.approx(glass.n_d, rel=1e-15)
    # Cauchy through n_d and V_d bends less than Sellmeier: 0.0007 low at 700 nm, less at C.
    assert by_abbe[0] == pytest.approx(glass.line("C"), abs=1e-3)


def test_nothing_disperses_without_dispersion() -> None:
    clear = Material(transmission=1, ior=1.5)
    assert indices(clear) == (1.5,) * 4
    assert ior_by_band(PRISM, (ALL_LIGHT,), LITERAL) == (1.6,)
    assert indices(Material(diffuse=0.5)) == (1.0,) * 4


def test_an_index_below_zero_is_refused() -> None:
    with pytest.raises(ValueError, match="down to -0.3"):
        indices(Material(transmission=1, ior=1.5, dispersion=-0.6))


# --- POV-Ray's law --------------------------------------------------------------------------------------------------

FOUR = [band.wavelength_nm for band in povray(4).bands]


def test_the_law_is_povrays() -> None:
    """Measured with a wedge, ior 1.6, dispersion 1.1, four samples [O 1.6]; the measurement is good to 1e-4."""
    from vitrail.optics.dispersion_fit import PovrayDispersion

    law = PovrayDispersion(1.6, 1.1)
    assert [law.index(nm) for nm in FOUR] == pytest.approx([1.54382, 1.58105, 1.61918, 1.65822], abs=1e-5)
    assert [law.index(nm) for nm in FOUR] == pytest.approx([1.54375, 1.58114, 1.61919, 1.65812], abs=2e-4)


def test_spread_is_exact_at_the_ends() -> None:
    law = fit(FOUR, indices(PRISM), "spread")
    assert (law.ior, law.dispersion) == pytest.approx((1.647301, 1.080790), abs=5e-7)
    assert law.residual_by_band == pytest.approx((0, -0.0006, -0.0006, 0), abs=3e-5)


# [ecosystem notes 0.2], printed to 1e-5; the notes fit n, we fit ln n.
FITS = [
    ("N-BK7", "nd-vd", 1.51834, 1.01098),
    ("N-SF11", "nd-vd", 1.79057, 1.03579),
    ("N-BK7", "bands", 1.51960, 1.01269),
    ("N-SF11", "bands", 1.79661, 1.04344),
]


@pytest.mark.parametrize(("name", "method", "ior", "dispersion"), FITS)
def test_fits_to_real_glass(name: str, method: str, ior: float, dispersion: float) -> None:
    glass = glass_named(name)
    wavelengths = FOUR if method == "bands" else [LINE_NM[line] for line in "dFC"]
    law = fit(wavelengths, [glass.index(nm) for nm in wavelengths], method)  # type: ignore[arg-type]
    assert (law.ior, law.dispersion) == pytest.approx((ior, dispersion), abs=1e-5)
    if method == "bands":
        assert law.largest_residual == pytest.approx({"N-BK7": 0.0013, "N-SF11": 0.0066}[name], abs=6e-5)


def test_two_bands_are_fitted_exactly() -> None:
    assert fit(FOUR[:2], (1.5, 1.6)).largest_residual < 1e-15 * 4


def test_abbe_is_kept() -> None:
    law = through_abbe(1.5168, 64.17)
    n = {line: law.index(LINE_NM[line]) for line in "CdF"}
    assert n["d"] == pytest.approx(1.5168, rel=1e-14)
    assert (n["d"] - 1) / (n["F"] - n["C"]) == pytest.approx(64.17, rel=1e-10)


def test_too_few_bands_are_refused() -> None:
    with pytest.raises(ValueError, match="two or more"):
        fit([500.0], [1.5])
