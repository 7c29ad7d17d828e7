"""Colours against the published values of CIE and Sharma."""

from __future__ import annotations

import numpy as np
import pytest

from vitrail.optics.colour import RGB_TO_XYZ, chromaticity, delta_e_2000, lab, luminance, xyz


def test_white_is_d65() -> None:
    assert chromaticity([1, 1, 1]) == pytest.approx([0.3127, 0.3290], abs=1e-12)
    assert luminance([1, 1, 1]) == pytest.approx(1, abs=1e-15)
    assert lab([1, 1, 1]) == pytest.approx([100, 0, 0], abs=1e-12)
    assert lab([0, 0, 0]) == pytest.approx([0, 0, 0], abs=1e-12)


def test_the_primaries_are_rec_709() -> None:
    expected = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]]
    np.testing.assert_allclose(chromaticity(np.eye(3)), expected, atol=1e-12)


def test_grey_of_18_percent() -> None:
    """L* = 116 * 0.18^(1/3) - 16."""
    assert lab([0.18, 0.18, 0.18])[0] == pytest.approx(49.4961, abs=1e-4)


def test_black_has_no_chromaticity() -> None:
    assert np.isnan(chromaticity([0, 0, 0])).all()


def test_delta_e_2000_on_a_pair_of_sharma() -> None:
    """Pair 1 of Sharma, Wu and Dalal (2005): dE = 2.0425."""
    first, second = np.array([50, 2.6772, -79.7751]), np.array([50, 0, -82.7485])

    def rgb(values: np.ndarray) -> np.ndarray:
        # Undo Lab.
        fy = (values[0] + 16) / 116
        f = np.array([fy + values[1] / 500, fy, fy - values[2] / 200])
        ratio = np.where(f > 6 / 29, f**3, 3 * (6 / 29) ** 2 * (f - 4 / 29))
        return np.linalg.solve(RGB_TO_XYZ, ratio * xyz([1, 1, 1]))

    assert delta_e_2000(rgb(first), rgb(second)) == pytest.approx(2.0425, abs=5e-5)
    assert delta_e_2000([0.5, 0.2, 0.1], [0.5, 0.2, 0.1]) == 0
