"""What people call each metric and the measure in which they read its bound: the one list, by family.

A sentence about a patch begins with its light ("agrees to within 1.0 %") and goes on with the other aspects ("its place
to 0.6 mm"). Metrics of one aspect share its name, and the largest bound among them speaks.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from vitrail.base.phenomenon import Phenomenon


class Measure(StrEnum):
    """How a bound is read: as a share of what the number should be, as a share of the light, or in its own unit."""

    OF_IDEAL = "of ideal"
    OF_LIGHT = "of light"
    LENGTH = "length"
    ANGLE = "angle"
    COLOUR = "colour"
    HUE = "hue"
    COUNT = "count"
    PER_METRE = "per metre"


@dataclass(frozen=True)
class PlainName:
    """``aspect`` is empty for the light itself. Only a ``leading`` aspect is told where it agrees."""

    aspect: str
    measure: Measure
    leading: bool = True


_LIGHT = PlainName("", Measure.OF_IDEAL)
_PLACE = PlainName("place", Measure.LENGTH)
_RADIUS = PlainName("radius", Measure.OF_IDEAL)
_RINGS = PlainName("brightness from ring to ring", Measure.OF_IDEAL, leading=False)
_AREA = PlainName("area", Measure.OF_IDEAL, leading=False)
_EVENNESS = PlainName("evenness", Measure.OF_LIGHT, leading=False)
_HUE = PlainName("hue", Measure.HUE, leading=False)
_SPREAD = PlainName("spread", Measure.OF_IDEAL)
_WIDTH = PlainName("width", Measure.OF_IDEAL, leading=False)
_ORDER = PlainName("order of colours", Measure.COUNT, leading=False)
_PEAKS = PlainName("number of colours", Measure.COUNT, leading=False)
_BLUR = PlainName("blur", Measure.OF_IDEAL)
_CONTRAST = PlainName("contrast", Measure.OF_IDEAL)
_PENUMBRA = PlainName("penumbra", Measure.OF_IDEAL)
_DEPTH = PlainName("depth", Measure.OF_LIGHT)
_LOSS = PlainName("loss", Measure.OF_LIGHT)
_COEFFICIENT = PlainName("coefficient", Measure.OF_IDEAL)
_BOUNCED = PlainName("share from other faces", Measure.OF_IDEAL)

PLAIN_NAMES: Mapping[str, PlainName] = {
    "radiance_ratio": _LIGHT,
    "mean_radiance": _LIGHT,
    "transmittance": _LIGHT,
    "tilt": _EVENNESS,
    "tilt_shift": _EVENNESS,
    "bow": _EVENNESS,
    "bow_shift": _EVENNESS,
    "delta_e_2000": PlainName("colour", Measure.COLOUR),
    "chromaticity": _HUE,
    "chromaticity_shift": _HUE,
    "furnace_deviation": PlainName("energy", Measure.OF_LIGHT),
    "caustic_flux": _LIGHT,
    "flux_ratio": _LIGHT,
    "centroid": _PLACE,
    "centroid_shift": _PLACE,
    "r50": _RADIUS,
    "r90": _RADIUS,
    "r50_ratio": _RADIUS,
    "r90_ratio": _RADIUS,
    "annulus_mean": _RINGS,
    "annulus_ratio": _RINGS,
    "area": _AREA,
    "area_ratio": _AREA,
    "profile_correlation": PlainName("shape", Measure.OF_IDEAL, leading=False),
    "place": _PLACE,
    "place_shift": _PLACE,
    "place_deg": PlainName("direction", Measure.ANGLE),
    "spread": _SPREAD,
    "spread_deg": _SPREAD,
    "spread_ratio": _SPREAD,
    "rms_width": _WIDTH,
    "rms_width_ratio": _WIDTH,
    "colour_order": _ORDER,
    "colour_order_agreement": _ORDER,
    "peaks": _PEAKS,
    "peak_difference": _PEAKS,
    "displacement": _PLACE,
    "edge_place": _PLACE,
    "blur": _BLUR,
    "blur_deg": _BLUR,
    "blur_ratio": _BLUR,
    "blur_shift": PlainName("blur", Measure.LENGTH),
    "contrast": _CONTRAST,
    "contrast_ratio": _CONTRAST,
    "contrast_shift": PlainName("contrast", Measure.OF_LIGHT),
    "penumbra_width": _PENUMBRA,
    "penumbra_difference": PlainName("penumbra", Measure.LENGTH),
    "shadow_edge": PlainName("edge", Measure.LENGTH),
    "shadow_edge_shift": PlainName("edge", Measure.LENGTH),
    "shadow_depth": _DEPTH,
    "shadow_depth_shift": _DEPTH,
    "optical_depth": _LOSS,
    "optical_depth_shift": _LOSS,
    "absorption": _COEFFICIENT,
    "absorption_fit": _COEFFICIENT,
    "absorption_fit_shift": PlainName("coefficient", Measure.PER_METRE),
    "indirect_radiance": _BOUNCED,
    "indirect_ratio": _BOUNCED,
}

SUBJECTS: Mapping[Phenomenon, str] = {
    Phenomenon.DIFFUSION: "the scattered light",
    Phenomenon.REFLECTION: "the reflection",
    Phenomenon.REFRACTION: "the refracted picture",
    Phenomenon.TOTAL_INTERNAL_REFLECTION: "the total reflection",
    Phenomenon.COLOURED_TRANSMISSION: "the tinted light",
    Phenomenon.ABSORPTION: "the absorbed light",
    Phenomenon.CAUSTIC: "the caustic",
    Phenomenon.ROUGHNESS: "the blurred picture",
    Phenomenon.DISPERSION: "the spectrum",
    Phenomenon.SHADOW: "the shadow",
    Phenomenon.INDIRECT_LIGHT: "the indirect light",
}
"""What a sentence about an observation is about."""


def plain_name(metric: str) -> PlainName:
    """The plain name of a metric by its family; one that nobody has named keeps its own in its own unit."""
    family = metric.split(".")[0]
    return PLAIN_NAMES.get(family) or PlainName(family.replace("_", " "), Measure.COUNT)


def in_words(metric: str, amount: float, ideal: float, *, up: bool = True) -> str:
    """A size of a difference of ``metric`` as people read it: ``1.0 %``, ``0.6 mm``, ``0.02°``.

    ``amount`` is in the metric's unit. ``up`` rounds upwards to two digits, as a bound must be; else to the nearest.
    """
    measure = plain_name(metric).measure
    match measure:
        case Measure.OF_IDEAL if ideal != 0:
            return f"{_digits(100 * amount / abs(ideal), up)} %"
        case Measure.OF_LIGHT:
            return f"{_digits(100 * amount, up)} %"
        case Measure.LENGTH:
            scale, unit = _prefix(amount)
            return f"{_digits(amount / scale, up)} {unit}"
        case Measure.ANGLE:
            return f"{_digits(amount, up)}°"
        case Measure.COLOUR:
            return f"ΔE {_digits(amount, up)}"
        case Measure.HUE:
            return f"{_digits(amount, up)} in u′v′"
        case Measure.PER_METRE:
            return f"{_digits(amount, up)} per metre"
        case _:
            return _digits(amount, up)


def _prefix(metres: float) -> tuple[float, str]:
    """Metres, millimetres or micrometres: what leaves at least a tenth before the unit."""
    return (1.0, "m") if metres >= 0.1 else (1e-3, "mm") if metres >= 1e-4 or metres == 0 else (1e-6, "µm")


def _digits(value: float, up: bool) -> str:
    """Two digits without an exponent: 340, 12, 1.0, 0.041; exact zeros, and what is as good as that, are 0."""
    if value < 1e-6:
        return "0"
    decimals = 1 - math.floor(math.log10(value))
    # A bound that is 0.35 up to its last bit is 0.35.
    scaled = value * 10.0**decimals * (1 - 1e-9)
    whole = math.ceil(scaled) if up else round(scaled)
    if whole == 100:
        whole, decimals = 10, decimals - 1
    return f"{whole / 10.0**decimals:.{max(decimals, 0)}f}"
