"""POV-Ray's dispersion law, and the ``ior`` and ``dispersion`` that bring it closest to given indices.

The law is n(lambda) = ior * D^(-(lambda - 555) / 350), lambda in nm [P 3.2]: two numbers for any glass, so every fit
but of two bands leaves a residual, which belongs into the certificate.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, assert_never

from vitrail.optics.lines import LINE_NM

Method = Literal["bands", "nd-vd", "spread"]

CENTRE_NM, RANGE_NM = 555.0, 350.0


@dataclass(frozen=True)
class PovrayDispersion:
    """The two numbers of POV-Ray's law, and law minus wanted index in each band."""

    ior: float
    dispersion: float
    residual_by_band: tuple[float, ...] = ()

    def index(self, wavelength_nm: float) -> float:
        return self.ior * self.dispersion ** (-(wavelength_nm - CENTRE_NM) / RANGE_NM)

    @property
    def largest_residual(self) -> float:
        return max((abs(residual) for residual in self.residual_by_band), default=0.0)


def fit(wavelengths_nm: Sequence[float], indices: Sequence[float], method: Method = "bands") -> PovrayDispersion:
    """The law closest to ``indices`` at ``wavelengths_nm``.

    bands: least squares of ln n over all bands. spread: exact at the first and the last band.
    nd-vd: exact in n_d and n_F - n_C, for which exactly the three indices at d, F, C (in any order) are needed.
    Raises ValueError for fewer than two bands or an index that is not above 0.
    """
    if len(wavelengths_nm) != len(indices) or len(indices) < 2 or min(indices) <= 0:
        raise ValueError(f"a fit needs two or more positive indices with their wavelengths, got {list(indices)}")
    match method:
        case "bands":
            law = _least_squares(wavelengths_nm, indices)
        case "spread":
            law = _through(wavelengths_nm[0], indices[0], wavelengths_nm[-1], indices[-1])
        case "nd-vd":
            index = dict(zip(wavelengths_nm, indices, strict=True))
            n_d, n_f, n_c = (index[LINE_NM[line]] for line in ("d", "F", "C"))
            law = through_abbe(n_d, (n_d - 1) / (n_f - n_c))
        case _:
            assert_never(method)
    residuals = tuple(law.index(nm) - n for nm, n in zip(wavelengths_nm, indices, strict=True))
    return PovrayDispersion(law.ior, law.dispersion, residuals)


def through_abbe(n_d: float, abbe: float) -> PovrayDispersion:
    """The law with the given n_d and V_d: solves n_F / n_d - n_C / n_d = (n_d - 1) / (V_d n_d) for D by Newton."""
    wanted = (n_d - 1) / (abbe * n_d)
    to_f, to_c = _exponent(LINE_NM["F"]) - _exponent(LINE_NM["d"]), _exponent(LINE_NM["C"]) - _exponent(LINE_NM["d"])
    log_d = wanted / (to_f - to_c)
    for _ in range(50):
        value = math.exp(to_f * log_d) - math.exp(to_c * log_d) - wanted
        slope = to_f * math.exp(to_f * log_d) - to_c * math.exp(to_c * log_d)
        log_d -= value / slope
    return PovrayDispersion(n_d * math.exp(-_exponent(LINE_NM["d"]) * log_d), math.exp(log_d))


def _exponent(wavelength_nm: float) -> float:
    """The power of D at a wavelength."""
    return -(wavelength_nm - CENTRE_NM) / RANGE_NM


def _through(first_nm: float, first: float, last_nm: float, last: float) -> PovrayDispersion:
    log_d = math.log(last / first) / (_exponent(last_nm) - _exponent(first_nm))
    return PovrayDispersion(first * math.exp(-_exponent(first_nm) * log_d), math.exp(log_d))


def _least_squares(wavelengths_nm: Sequence[float], indices: Sequence[float]) -> PovrayDispersion:
    """The straight line through (exponent, ln n)."""
    xs, ys = [_exponent(nm) for nm in wavelengths_nm], [math.log(n) for n in indices]
    mean_x, mean_y = math.fsum(xs) / len(xs), math.fsum(ys) / len(ys)
    slope = math.fsum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys, strict=True))
    slope /= math.fsum((x - mean_x) ** 2 for x in xs)
    return PovrayDispersion(math.exp(mean_y - slope * mean_x), math.exp(slope))
