"""Fraunhofer lines: wavelengths in air, nanometres [Schott TIE-29, table 1]."""

from __future__ import annotations

LINE_NM = {
    "C": 656.2725,
    "d": 587.5618,
    "e": 546.0740,
    "F": 486.1327,
    "g": 435.8343,
}
"""Hydrogen C and F, helium d, mercury e and g."""
