"""The catalogue: refraction indices of real glasses by Sellmeier's equation.

n^2 - 1 = sum B l^2 / (l^2 - C), l the wavelength in micrometres; n is relative to air.

Constants of the Schott glasses: SCHOTT Zemax catalogue 2017-01-20b as kept by the refractiveindex.info database
(CC0 1.0). Fused silica: Malitson, J. Opt. Soc. Am. 55, 1205 (1965). Water at 20 C: Daimon and Masumura, Appl. Opt. 46,
3811 (2007). Many tables exchange SF11 with N-SF11 and SF10 with N-SF10: their n_d agree, their constants do not
[O 1.5]. The printed n_d and V_d are the makers' and test the constants.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vitrail.optics.lines import LINE_NM


@dataclass(frozen=True)
class Glass:
    """Sellmeier terms (B, C in square micrometres), and n_d and V_d as the maker prints them, None if not printed."""

    name: str
    terms: tuple[tuple[float, float], ...]
    printed_n_d: float | None = None
    printed_abbe: float | None = None

    def index(self, wavelength_nm: float) -> float:
        """Refraction index at a wavelength in air."""
        square = (wavelength_nm * 1e-3) ** 2
        return math.sqrt(1 + sum(b * square / (square - c) for b, c in self.terms))

    def line(self, name: str) -> float:
        """Refraction index at a Fraunhofer line."""
        return self.index(LINE_NM[name])

    @property
    def n_d(self) -> float:
        return self.line("d")

    @property
    def abbe(self) -> float:
        """V_d = (n_d - 1) / (n_F - n_C)."""
        return (self.n_d - 1) / (self.line("F") - self.line("C"))


def _schott(name: str, n_d: float, abbe: float, *constants: float) -> Glass:
    """A glass from its catalogue row: B1 C1 B2 C2 B3 C3."""
    return Glass(name, tuple(zip(constants[::2], constants[1::2], strict=True)), n_d, abbe)


CATALOGUE = {
    glass.name: glass
    for glass in (
        _schott(
            "N-BK7", 1.51680, 64.17,
            1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653,
        ),
        _schott(
            "N-K5", 1.52249, 59.48,
            1.08511833, 0.00661099503, 0.199562005, 0.024110866, 0.930511663, 111.982777,
        ),
        _schott(
            "N-BAK4", 1.56883, 55.98,
            1.28834642, 0.00779980626, 0.132817724, 0.0315631177, 0.945395373, 105.965875,
        ),
        _schott(
            "N-SK16", 1.62041, 60.32,
            1.34317774, 0.00704687339, 0.241144399, 0.0229005, 0.994317969, 92.7508526,
        ),
        _schott(
            "N-LAK8", 1.71300, 53.83,
            1.33183167, 0.00620023871, 0.546623206, 0.0216465439, 1.19084015, 82.5827736,
        ),
        _schott(
            "N-LASF44", 1.80420, 46.50,
            1.78897105, 0.00872506277, 0.38675867, 0.0308085023, 1.30506243, 92.7743824,
        ),
        _schott(
            "F2", 1.62004, 36.37,
            1.34533359, 0.00997743871, 0.209073176, 0.0470450767, 0.937357162, 111.886764,
        ),
        _schott(
            "N-F2", 1.62005, 36.43,
            1.39757037, 0.00995906143, 0.159201403, 0.0546931752, 1.2686543, 119.248346,
        ),
        _schott(
            "SF10", 1.72825, 28.41,
            1.61625977, 0.0127534559, 0.259229334, 0.0581983954, 1.07762317, 116.60768,
        ),
        _schott(
            "N-SF10", 1.72828, 28.53,
            1.62153902, 0.0122241457, 0.256287842, 0.0595736775, 1.64447552, 147.468793,
        ),
        _schott(
            "SF11", 1.78472, 25.76,
            1.73848403, 0.0136068604, 0.311168974, 0.0615960463, 1.17490871, 121.922711,
        ),
        _schott(
            "N-SF11", 1.78472, 25.68,
            1.73759695, 0.013188707, 0.313747346, 0.0623068142, 1.89878101, 155.23629,
        ),
        _schott(
            "N-SF66", 1.92286, 20.88,
            2.0245976, 0.0147053225, 0.470187196, 0.0692998276, 2.59970433, 161.817601,
        ),
        Glass(
            "fused-silica",
            ((0.6961663, 0.0684043**2), (0.4079426, 0.1162414**2), (0.8974794, 9.896161**2)),
        ),
        Glass(
            "water",
            (
                (5.684027565e-1, 5.101829712e-3),
                (1.726177391e-1, 1.821153936e-2),
                (2.086189578e-2, 2.620722293e-2),
                (1.130748688e-1, 1.069792721e1),
            ),
        ),
    )
}  # fmt: skip


def glass_named(name: str) -> Glass:
    """The catalogue glass of that name; raises KeyError with the names there are."""
    try:
        return CATALOGUE[name]
    except KeyError:
        raise KeyError(f"no glass {name!r} in the catalogue; it has {', '.join(CATALOGUE)}") from None


def abbe_index(n_d: float, abbe: float, wavelength_nm: float) -> float:
    """Cauchy's n = A + B / lambda^2 through n_d with n_F - n_C = (n_d - 1) / V_d, as in glTF and OpenPBR."""
    slope = (n_d - 1) / abbe / (LINE_NM["F"] ** -2 - LINE_NM["C"] ** -2)
    return n_d + slope * (wavelength_nm**-2 - LINE_NM["d"] ** -2)
