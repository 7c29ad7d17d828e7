"""Luminance along a patch by formula, as the report draws it beside both engines."""

from __future__ import annotations

from mpmath import cos, mpf, pi, quad, radians, sqrt

from tests.closed_forms.ball_lens import irradiance_gain
from tests.closed_forms.prisms import screen_height

INDEX, DROP, HALF, ALBEDO = mpf("1.5"), 2, mpf("1.2"), mpf("0.8")
"""ball_lens: a unit ball over a plane, the half edge of its patch; with E = pi the plane's radiance is its albedo."""

RIGHT = (*(mpf(k) / 20 for k in range(25)), mpf("0.975"), mpf("0.99"))
CAUSTIC_AT = tuple(sorted({sign * u for u in RIGHT for sign in (-1, 1)}))
"""Closer where the edge of the shadow is crossed lengthwise."""

BEAM_HALF, IRRADIANCE, INCIDENCE, APEX, SCREEN = mpf("0.02"), 20, 55, 60, mpf("2.5")
BANDS = {"1.600": (0.5, 0, 0), "1.632": (0.5, 0.5, 0), "1.664": (0, 0.5, 0), "1.696": (0, 0, 1)}
"""prism_screen: half the width of its beam; the index of each band of the paper and its weight."""

LUMINANCE = ("0.2126", "0.7152", "0.0722")
MIDDLE = mpf("1e-6")
"""So near the axis the caustic is as bright as on it, where the Jacobian is 0 / 0."""

EDGE = mpf("1e-6")
"""A step is drawn as a slope of a micrometre."""


def across_the_caustic(u):
    """Mean over v of the ball lens's floor at ``u``: the caustic, and the sun where the ball casts no shadow."""
    u = abs(mpf(u))
    caustic = quad(lambda v: irradiance_gain(max(sqrt(u**2 + v**2), MIDDLE), INDEX, DROP), [0, HALF])
    shadow = sqrt(1 - u**2) if u < 1 else mpf(0)
    return ALBEDO * (caustic + HALF - shadow) / HALF


def caustic_profile():
    """(along, positions, values)."""
    half = [float(across_the_caustic(u)) for u in CAUSTIC_AT if u >= 0]
    return "u", [float(u) for u in CAUSTIC_AT], [*reversed(half[1:]), *half]


def spectrum_profile():
    """(along, positions, values): four stripes on the prism's screen, each with all the light of its band.

    The ends of a stripe are the edge rays of the beam, which meet the left face BEAM_HALF / cos i from its middle.
    """
    aside = BEAM_HALF / cos(radians(mpf(INCIDENCE)))
    places, values = [mpf("-0.4")], [mpf(0)]
    stripes = []
    for index, weight in BANDS.items():
        ends = sorted(screen_height(mpf(index), APEX, INCIDENCE, SCREEN, side * aside) + 1 for side in (-1, 1))
        bright = sum(mpf(share) * mpf(part) for share, part in zip(weight, LUMINANCE, strict=True))
        stripes.append((ends, ALBEDO / pi * IRRADIANCE * 2 * BEAM_HALF / (ends[1] - ends[0]) * bright))
    for (low, high), value in sorted(stripes):
        places += [low - EDGE, low, high, high + EDGE]
        values += [mpf(0), value, value, mpf(0)]
    return "v", [float(x) for x in (*places, mpf("0.4"))], [float(x) for x in (*values, mpf(0))]


PROFILES = {("ball_lens", "caustic"): caustic_profile, ("prism_screen", "spectrum"): spectrum_profile}
