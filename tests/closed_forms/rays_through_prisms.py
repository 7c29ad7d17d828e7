"""Prisms: single rays against closed forms. Each function returns its largest error."""

from __future__ import annotations

import math

from mpmath import asin, degrees, mpf, radians, sqrt

from tests.closed_forms import prisms
from tests.closed_forms.one_ray import before, direction_of, events, follow, turn

DENSE_PRISM = """
materials: {flint: {transmission: 1, ior: 1.6, dispersion: 0.032}}
objects: [{name: prism, prism: {apex_deg: 60, side: 1, height: 1}, material: flint}]
"""
BAND_INDICES = ("1.600", "1.632", "1.664", "1.696")
LEFT_FACE = (-0.25, math.sqrt(3) / 12, 0.0)
"""The middle of the left face, whose inward normal points 30 degrees down from +x."""


def through_prism(body, incidence_deg, **light):
    way = direction_of(float(incidence_deg) - 30)
    vertices = follow(body, before(LEFT_FACE, way, 2.0), way, **light)
    assert events(vertices) == "enter exit escape"
    return abs(turn(vertices))


def prism_bands():
    """Figure 8's prism at 55 degrees of incidence."""
    return max(
        abs(through_prism(DENSE_PRISM, 55, band=k) - radians(prisms.deviation_deg(mpf(n), 60, 55)))
        for k, n in enumerate(BAND_INDICES)
    )


def prism_least_deviation():
    """The same prism where each band is turned least."""
    worst = 0
    for k, n in enumerate(BAND_INDICES):
        incidence = degrees(asin(mpf(n) / 2))
        found = through_prism(DENSE_PRISM, incidence, band=k)
        worst = max(worst, abs(found - radians(prisms.least_deviation_deg(mpf(n), 60))))
    return worst


SELLMEIER = {
    "N-BK7": ("1.03961212 0.231792344 1.01046945", "0.00600069867 0.0200179144 103.560653"),
    "SF10": ("1.61625977 0.259229334 1.07762317", "0.0127534559 0.0581983954 116.60768"),
}
"""Schott's catalogue, B and C in um^2, copied here on their own."""

LINES_NM = {"C": "656.2725", "d": "587.5618", "e": "546.0740", "F": "486.1327"}
PRINTED = {"N-BK7": "1.51432 1.51680 1.51872 1.52238", "SF10": "1.72085 1.72825 1.73430 1.74648"}
"""Indices at these lines as the data sheets print them."""


def catalogue_index(glass, line):
    square = (mpf(LINES_NM[line]) / 1000) ** 2
    terms = zip(*(text.split() for text in SELLMEIER[glass]), strict=True)
    return sqrt(1 + sum(mpf(b) * square / (square - mpf(c)) for b, c in terms))


def glass_lines():
    """N-BK7 and SF10 at the Fraunhofer lines C, d, e, F, least deviation."""
    worst = 0
    for glass, printed in PRINTED.items():
        body = DENSE_PRISM.replace("ior: 1.6, dispersion: 0.032", f"glass: {glass}")
        for line, rounded in zip(LINES_NM, printed.split(), strict=True):
            index = catalogue_index(glass, line)
            assert abs(index - mpf(rounded)) < mpf("5e-6")
            found = through_prism(body, degrees(asin(index / 2)), wavelength_nm=float(LINES_NM[line]))
            worst = max(worst, abs(found - radians(prisms.least_deviation_deg(index, 60))))
    return worst
