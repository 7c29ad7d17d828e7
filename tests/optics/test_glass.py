"""The glass catalogue against the makers' printed values and the deviations of [O 1.5]."""

from __future__ import annotations

import math
from typing import get_args

import pytest

from vitrail.optics.glass import CATALOGUE, abbe_index, glass_named
from vitrail.optics.lines import LINE_NM
from vitrail.scene.model import Glass as GlassNames

PRINTED = [glass for glass in CATALOGUE.values() if glass.printed_n_d is not None]


def minimum_deviation_deg(index: float, apex_deg: float = 60) -> float:
    """The smallest deviation of a prism: 2 asin(n sin(A/2)) - A."""
    half = math.radians(apex_deg) / 2
    return math.degrees(2 * math.asin(index * math.sin(half))) - apex_deg


def test_the_language_names_exactly_the_catalogue() -> None:
    assert set(get_args(GlassNames)) == set(CATALOGUE)


@pytest.mark.parametrize("glass", PRINTED, ids=lambda glass: glass.name)
def test_makers_printed_values(glass) -> None:  # type: ignore[no-untyped-def]
    # Makers print n_d to 1e-5 and V_d to 0.01: allow one unit of the last printed digit.
    assert glass.n_d == pytest.approx(glass.printed_n_d, abs=1e-5)
    assert glass.abbe == pytest.approx(glass.printed_abbe, abs=0.01)


def test_fused_silica_and_water_against_their_papers() -> None:
    # Malitson gives n_d = 1.45846; Daimon and Masumura n = 1.33336 at 589.3 nm (20 C), both to the digits shown.
    assert glass_named("fused-silica").n_d == pytest.approx(1.45846, abs=1e-5)
    assert glass_named("water").index(589.3) == pytest.approx(1.33334, abs=3e-5)


def test_sf11_is_not_n_sf11() -> None:
    """n_d agrees to the printed digits, the dispersion does not: exchanged constants show here [O 1.5]."""
    lead, new = glass_named("SF11"), glass_named("N-SF11")
    assert lead.n_d == pytest.approx(new.n_d, abs=1e-5)
    assert lead.abbe - new.abbe == pytest.approx(0.077, abs=1e-3)
    assert glass_named("SF10").terms[0][0] == 1.61625977 and glass_named("N-SF10").terms[0][0] == 1.62153902


# Lines C, d, e, F at d-line minimum deviation, apex 60 degrees [O 1.5].
DEVIATIONS = {
    "N-BK7": (38.4293, 38.6467, 38.8159, 39.1390),
    "SF10": (58.7329, 59.5659, 60.2617, 61.7070),
    "N-SF11": (65.2496, 66.3426, 67.2707, 69.2508),
}


@pytest.mark.parametrize("name", DEVIATIONS)
def test_prism_deviations_per_line(name: str) -> None:
    """Trace each line through the prism at the incidence of the d line's minimum deviation."""
    glass, half = glass_named(name), math.radians(30)
    incidence = math.asin(glass.n_d * math.sin(half))
    for line, expected in zip("CdeF", DEVIATIONS[name], strict=True):
        n = glass.line(line)
        second = 2 * half - math.asin(math.sin(incidence) / n)
        leaving = math.asin(n * math.sin(second))
        # The table is printed to 1e-4 degrees.
        assert math.degrees(incidence + leaving - 2 * half) == pytest.approx(expected, abs=6e-5)


def test_cauchy_from_abbe_keeps_n_d_and_v_d() -> None:
    n = {line: abbe_index(1.5168, 64.17, LINE_NM[line]) for line in "CdF"}
    assert n["d"] == pytest.approx(1.5168, rel=1e-15)
    assert (n["d"] - 1) / (n["F"] - n["C"]) == pytest.approx(64.17, rel=1e-12)
    # glTF and OpenPBR print the slope as 0.5236 um2 (n_d - 1) / V_d.
    slope = (abbe_index(1.5168, 64.17, 400) - 1.5168) / (0.4**-2 - 0.5875618**-2) / (0.5168 / 64.17)
    assert slope == pytest.approx(0.5236, abs=1e-4)


def test_an_unknown_glass_is_named() -> None:
    with pytest.raises(KeyError, match="no glass 'BK8'"):
        glass_named("BK8")
