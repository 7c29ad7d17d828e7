"""The engines by name, as commands, records and images write them."""

from __future__ import annotations

from enum import StrEnum


class EngineName(StrEnum):
    """A program that renders."""

    TRACER = "tracer"
    POVRAY = "povray"
