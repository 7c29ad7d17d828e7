"""From which distance on two surfaces count as apart."""

from __future__ import annotations

TOUCH = 1e-9
"""Solids that reach into each other by less than this share of their size and distance from the origin only touch."""
