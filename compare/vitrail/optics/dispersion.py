"""The refraction index of a material in each band.

Reads a scene's material and its ``paper`` switches by their fields alone: formulas depend on nothing above them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

from vitrail.optics.bands import Band
from vitrail.optics.glass import abbe_index, glass_named

_PAPER_BANDS = ("red", "yellow", "green", "blue")

_REDDEST_NM, _STEP_NM = 686.25, 87.5
"""Centre of the reddest of four equal bands, and their distance: there ``sigma + delta i`` has i = 0, 1, 2, 3."""


class Refracting(Protocol):
    """The fields of a scene's material that say how strongly it refracts."""

    @property
    def ior(self) -> float | None: ...

    @property
    def dispersion(self) -> Any: ...

    @property
    def glass(self) -> str | None: ...


class PaperSwitches(Protocol):
    """The switches of a scene that say what the paper's sigma and delta mean."""

    @property
    def dispersion(self) -> str: ...

    @property
    def dispersion_reference(self) -> str: ...


def ior_by_band(material: Refracting, bands: Sequence[Band], paper: PaperSwitches) -> tuple[float, ...]:
    """The index of each band; 1 for a material without any. Raises ValueError where an index is not above 0."""
    indices = tuple(_index(material, band, paper) for band in bands)
    if min(indices) <= 0:
        raise ValueError(f"dispersion brings the refraction index down to {min(indices):.4g}; an index is above 0")
    return indices


def reference_ior(material: Refracting) -> float:
    """The index that is written in the scene: sigma, or that of the d line for catalogue glass; 1 without any."""
    if material.glass is not None:
        return glass_named(material.glass).n_d
    return 1.0 if material.ior is None else material.ior


def _index(material: Refracting, band: Band, paper: PaperSwitches) -> float:
    """Dispatch on how the material gives its dispersion."""
    dispersion = material.dispersion
    if band.wavelength_nm is None or material.ior is None and material.glass is None:
        return reference_ior(material)
    if material.glass is not None:
        return glass_named(material.glass).index(band.wavelength_nm)
    assert material.ior is not None
    if dispersion is None or dispersion == 0:
        return material.ior
    abbe = getattr(dispersion, "abbe", None)
    if abbe is not None:
        return abbe_index(material.ior, abbe, band.wavelength_nm)
    return material.ior + index_step(dispersion, paper) * (band_position(band) - ior_position(paper))


def index_step(dispersion: float, paper: PaperSwitches) -> float:
    """The paper's delta: the index from one of its four bands to the next; ``span`` gives it from first to last."""
    return dispersion / 3 if paper.dispersion == "span" else dispersion


def ior_position(paper: PaperSwitches) -> float:
    """Where the scene's ``ior`` holds, on the scale of ``band_position`` [O 1.1 items 23, 24]."""
    return {"red": 0.0, "d_line": 1.0, "middle": 1.5}[paper.dispersion_reference]


def band_position(band: Band) -> float:
    """The paper's i in ``sigma + delta i``: 0 red, 1 yellow, 2 green, 3 blue.

    For bands given by wavelength i runs linearly over it, and is 0 to 3 at the centres of four equal bands.
    """
    if band.name in _PAPER_BANDS:
        return float(_PAPER_BANDS.index(band.name))
    assert band.wavelength_nm is not None
    return (_REDDEST_NM - band.wavelength_nm) / _STEP_NM
