"""How white light is split into bands: their colours, which add up to white, and their wavelengths.

``paper``: the four colours of the paper, red, yellow, green, blue, with the weights of [O 1.4] for y = 1/2.
``povray``: the bands of POV-Ray, N of equal width between 380 and 730 nm, its hues scaled to add up to white [P 3.2].
``spectral N``: the same intervals with the colours of daylight in them (CIE 1931, D65), signed linear RGB.
``continuous``: as many spectral bands as a picture can tell apart.
"""

from __future__ import annotations

import csv
import functools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib import resources
from typing import Protocol, runtime_checkable

from vitrail.base.colour import Triplet
from vitrail.optics.lines import LINE_NM

SHORTEST_NM, LONGEST_NM = 380.0, 730.0
"""The range that all spectral models share; it holds 99.98 % of each channel of daylight."""

CONTINUOUS_BANDS = 140
"""Bands that stand for continuous wavelengths, 2.5 nm each."""

POVRAY_BANDS = 4
"""Bands of the ``povray`` model, as many as the paper has colours."""


@dataclass(frozen=True)
class Band:
    """A part of the light that keeps one index; ``weight`` is its linear RGB share of white, possibly signed."""

    name: str
    weight: Triplet
    wavelength_nm: float | None


@dataclass(frozen=True)
class BandModel:
    """Bands from red to blue; the weights of each channel sum to exactly 1."""

    name: str
    bands: tuple[Band, ...]


@runtime_checkable
class SpectralChoice(Protocol):
    """What ``transport.bands: {spectral: N}`` of a scene looks like."""

    @property
    def spectral(self) -> int: ...


ALL_LIGHT = Band("all", (1.0, 1.0, 1.0), None)
"""The only band where nothing disperses."""

PAPER = BandModel(
    "paper",
    (
        Band("red", (0.5, 0.0, 0.0), LINE_NM["C"]),
        Band("yellow", (0.5, 0.5, 0.0), LINE_NM["d"]),
        Band("green", (0.0, 0.5, 0.0), LINE_NM["e"]),
        Band("blue", (0.0, 0.0, 1.0), LINE_NM["g"]),
    ),
)
"""The lines are those between which the paper's delta is what its table says: green e, blue g [O 1.1 item 23]."""


def band_model(choice: str | SpectralChoice) -> BandModel:
    """The model that ``transport.bands`` of a scene names."""
    if isinstance(choice, SpectralChoice):
        return spectral(choice.spectral)
    match choice:
        case "paper":
            return PAPER
        case "povray":
            return povray(POVRAY_BANDS)
        case "continuous":
            return BandModel("continuous", spectral(CONTINUOUS_BANDS).bands)
        case _:
            raise ValueError(
                f"there is no band model {choice!r}; the models are paper, povray, spectral and continuous"
            )


def povray(count: int) -> BandModel:
    """POV-Ray's bands for ``dispersion_samples count``, from red to blue, so scaled that white stays white."""
    return _scaled_to_white("povray", povray_hues(count))


def povray_hues(count: int) -> tuple[Band, ...]:
    """The same bands as POV-Ray itself weighs them: their sum is its own white, (0.9938, 1.0000, 0.9962) [P 3.2]."""
    edges, cumulative = _povray_hues()
    return _bands(count, [_interpolate(edges, column, _edges(count)) for column in cumulative])


@functools.lru_cache(maxsize=32)
def spectral(count: int) -> BandModel:
    """``count`` bands of equal width, coloured as the daylight in them; each channel sums to exactly 1."""
    edges, cumulative = _daylight()
    return _scaled_to_white(
        f"spectral {count}", _bands(count, [_interpolate(edges, c, _edges(count)) for c in cumulative])
    )


def _scaled_to_white(name: str, bands: tuple[Band, ...]) -> BandModel:
    """The bands with each channel scaled to a sum of exactly 1."""
    channels = [_summing_to_one([band.weight[channel] for band in bands]) for channel in range(3)]
    weights = zip(*channels, strict=True)
    made = (Band(band.name, weight, band.wavelength_nm) for band, weight in zip(bands, weights, strict=True))
    return BandModel(name, tuple(made))


def _edges(count: int) -> list[float]:
    return [SHORTEST_NM + (LONGEST_NM - SHORTEST_NM) * k / count for k in range(count + 1)]


def _bands(count: int, columns: list[list[float]]) -> tuple[Band, ...]:
    """Bands from red to blue out of the cumulative colour at the edges, which run from blue to red."""

    def made(k: int) -> Band:
        center = SHORTEST_NM + (LONGEST_NM - SHORTEST_NM) * (k + 0.5) / count
        red, green, blue = (column[k + 1] - column[k] for column in columns)
        return Band(f"{center:g} nm", (red, green, blue), center)

    return tuple(made(k) for k in reversed(range(count)))


def _interpolate(places: Sequence[float], values: Sequence[float], wanted: Sequence[float]) -> list[float]:
    """Piecewise linear; ``places`` ascend and cover ``wanted``."""
    found, k = [], 0
    for place in wanted:
        while k < len(places) - 2 and places[k + 1] < place:
            k += 1
        share = (place - places[k]) / (places[k + 1] - places[k])
        found.append(values[k] + share * (values[k + 1] - values[k]))
    return found


def _summing_to_one(weights: list[float]) -> list[float]:
    """Scale weights to multiples of 2^-40 whose sum is 1, so that adding them in any order gives 1 to the last bit."""
    total = math.fsum(weights)
    grid = 2.0**40
    scaled = [round(weight / total * grid) for weight in weights]
    largest = max(range(len(scaled)), key=lambda k: abs(scaled[k]))
    scaled[largest] += round(grid) - sum(scaled)
    return [weight / grid for weight in scaled]


# --- tables ---------------------------------------------------------------------------------------------------------


@functools.cache
def _daylight() -> tuple[list[float], list[list[float]]]:
    """Wavelengths and the cumulative red, green, blue of daylight up to each, by the trapezoid rule."""
    rows = list(_rows("visible_light.csv"))
    places = [row[0] for row in rows]
    return places, [_running_integral(places, [row[channel] for row in rows]) for channel in (1, 2, 3)]


@functools.cache
def _povray_hues() -> tuple[list[float], list[list[float]]]:
    """Wavelengths and the cumulative red, green, blue of POV-Ray's hues, as measured."""
    rows = list(_rows("povray_hues.csv"))
    return [row[0] for row in rows], [[row[channel] for row in rows] for channel in (1, 2, 3)]


def _running_integral(places: list[float], density: list[float]) -> list[float]:
    total = [0.0]
    for k in range(1, len(places)):
        total.append(total[-1] + (places[k] - places[k - 1]) * (density[k] + density[k - 1]) / 2)
    return total


def _rows(name: str) -> Iterator[list[float]]:
    """The numbers of a table of this folder, without its comment and its header."""
    text = (resources.files("vitrail.optics") / "tables" / name).read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    for row in csv.reader(lines[1:]):
        yield [float(cell) for cell in row]
