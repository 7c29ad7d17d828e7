"""Band models: they add up to white, and agree with POV-Ray's and the observer's published numbers."""

from __future__ import annotations

import csv
import random
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from vitrail.optics.bands import PAPER, BandModel, band_model, povray, povray_hues, spectral


def total(model: BandModel) -> list[float]:
    return [sum(band.weight[channel] for band in model.bands) for channel in range(3)]


@pytest.mark.parametrize(
    "model", [PAPER, povray(4), povray(13), spectral(2), spectral(7), spectral(31), spectral(140), spectral(256)]
)
def test_bands_add_up_to_white_in_any_order(model: BandModel) -> None:
    for seed in range(5):
        order = list(model.bands)
        random.Random(seed).shuffle(order)
        assert total(BandModel(model.name, tuple(order))) == [1.0, 1.0, 1.0]


def test_the_papers_bands() -> None:
    assert [band.name for band in PAPER.bands] == ["red", "yellow", "green", "blue"]
    # Luminance shares for y = 1/2, printed to 1e-4 [O 1.4].
    luminance = np.array([0.2126, 0.7152, 0.0722])
    shares = [float(luminance @ band.weight) for band in PAPER.bands]
    assert shares == pytest.approx([0.1063, 0.4639, 0.3576, 0.0722], abs=5e-5)


# Weights as printed in [P 3.2], from blue to red; printed to 1e-4.
POVRAY = {
    2: {467.5: (0.0395, 0.2724, 0.9840), 642.5: (0.9543, 0.7276, 0.0122)},
    4: {
        423.75: (0.0395, 0, 0.4754),
        511.25: (0, 0.2724, 0.5086),
        598.75: (0.3831, 0.6450, 0.0122),
        686.25: (0.5712, 0.0826, 0),
    },
    7: {
        405: (0.0365, 0, 0.2047),
        455: (0.0030, 0, 0.3665),
        505: (0, 0.1095, 0.3270),
        555: (0.0098, 0.3612, 0.0980),
        605: (0.2708, 0.3787, 0),
        655: (0.4167, 0.1506, 0),
        705: (0.2570, 0, 0),
    },
}


@pytest.mark.parametrize("count", POVRAY)
def test_povrays_hues(count: int) -> None:
    bands = povray_hues(count)
    assert [band.wavelength_nm for band in bands] == sorted(POVRAY[count], reverse=True)
    for band in bands:
        # Our table is rounded to 1e-4 at each edge, theirs in print.
        assert band.weight == pytest.approx(POVRAY[count][band.wavelength_nm], abs=1.6e-4)


@pytest.mark.parametrize("count", [2, 3, 4, 7, 13, 140])
def test_povrays_white_is_the_same_for_every_number_of_bands(count: int) -> None:
    own_white = [0.9938, 1.0, 0.9962]
    hues = povray_hues(count)
    assert total(BandModel("own", hues)) == pytest.approx(own_white, abs=1e-12)
    for band, hue in zip(povray(count).bands, hues, strict=True):
        assert band.weight == pytest.approx(np.divide(hue.weight, own_white), abs=1e-11)


def test_spectral_bands_share_povrays_wavelengths() -> None:
    assert [band.wavelength_nm for band in spectral(4).bands] == [band.wavelength_nm for band in povray(4).bands]


def test_spectral_colours_are_those_of_the_spectrum() -> None:
    """Red, green and blue light lie where they should, and saturated green light has negative red."""
    bands = spectral(35).bands
    brightest = [max(bands, key=lambda band: band.weight[channel]).wavelength_nm for channel in range(3)]
    assert 590 <= brightest[0] <= 620 and 525 <= brightest[1] <= 560 and 440 <= brightest[2] <= 470
    green = next(band for band in bands if band.wavelength_nm == 515)
    assert green.weight[0] < 0 < green.weight[1]


def test_the_table_of_daylight_is_the_observers() -> None:
    """Make it again from the CIE data of colour-science."""
    import colour

    observer = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy()
    observer = observer.align(colour.SpectralShape(380, 730, 1))
    daylight = colour.SDS_ILLUMINANTS["D65"]
    power = np.interp(np.arange(380, 731), daylight.wavelengths, daylight.values)
    to_rgb = colour.RGB_COLOURSPACES["ITU-R BT.709"].matrix_XYZ_to_RGB
    rgb = (observer.values * power[:, None]) @ to_rgb.T
    rgb /= rgb.sum(axis=0)
    lines = Path("compare/vitrail/optics/tables/visible_light.csv").read_text().splitlines()[2:]
    table = np.array([[float(cell) for cell in row[1:]] for row in csv.reader(lines)])
    # The table is written with nine digits.
    np.testing.assert_allclose(table, rgb, rtol=1e-8, atol=1e-15)


def test_models_by_the_names_of_the_language() -> None:
    assert band_model("paper") is PAPER
    assert len(band_model("povray").bands) == 4
    assert len(band_model(SimpleNamespace(spectral=12)).bands) == 12
    assert len(band_model("continuous").bands) == 140
    with pytest.raises(ValueError, match="no band model 'rainbow'"):
        band_model("rainbow")
