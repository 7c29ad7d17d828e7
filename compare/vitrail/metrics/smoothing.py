"""What the resolution of an image did to a number: smooth the image once more, and see how much it changes.

Photons are gathered in a disc, a pixel is a mean, and so is a cell of a patch. What smooths light once takes nearly as
much off a steep place the second time, so the change is the size of the first error, in the unit of whatever was
measured. Of each only the second moment acts on structures larger than it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import fft

from vitrail.images.patch import PatchSamples

GATHERED = "caustic"
"""The layer that is summed over gather discs."""

CELLS = 2 / 12
"""Variance of a pixel and of a cell, square cells: less was lost where the cells of a patch are pixels."""


def smoothed_again(samples: PatchSamples, gather_radius_m: float) -> PatchSamples:
    """The samples with their light spread once more by what spread it before; light stays within the patch.

    Along each direction that is the variance of a disc, radius^2 / 4, of a pixel and of a cell, which is as large, each
    width^2 / 12. A Gaussian of their sum stands for the three, because any size of cells can hold it.
    """
    smooth = _spread(samples.values, samples, gather_radius_m**2 / 4, CELLS)
    return samples.disturbed(smooth - samples.values)


def gathered_again(samples: PatchSamples, gather_radius_m: float) -> PatchSamples:
    """The samples with their gathered light alone, which is a layer, spread over one more disc."""
    light = samples.layers.get(GATHERED)
    if light is None:
        return samples
    smooth = _spread(light, samples, gather_radius_m**2 / 4, 0.0)
    return replace(samples, values=samples.values + (smooth - light), layers={**samples.layers, GATHERED: smooth})


def pixelled_again(samples: PatchSamples) -> PatchSamples:
    """The samples with all their light, layer by layer, spread over one more pixel and cell."""
    layers = {name: _spread(layer, samples, 0.0, CELLS) for name, layer in samples.layers.items()}
    return replace(samples, values=_spread(samples.values, samples, 0.0, CELLS), layers=layers)


def _spread(light: np.ndarray, samples: PatchSamples, disc_m2: float, cells: float) -> np.ndarray:
    """Light (nv, nu, 3) spread along each axis by a variance in m^2 and another in square cells."""
    down = _attenuation(light.shape[0], samples.cell_v_m, disc_m2, cells)[:, None, None]
    across = _attenuation(light.shape[1], samples.cell_u_m, disc_m2, cells)[None, :, None]
    # The cosine transform mirrors the patch at its edges: what would leave it comes back.
    result: np.ndarray = fft.idctn(fft.dctn(light, axes=(0, 1)) * down * across, axes=(0, 1))
    return result


def _attenuation(cells: int, cell_m: float, disc_m2: float, square_cells: float) -> np.ndarray:
    """What smoothing leaves of each cosine along one direction, (cells,)."""
    frequencies = np.pi * np.arange(cells) / (cells * cell_m)
    result: np.ndarray = np.exp(-0.5 * (disc_m2 + square_cells * cell_m**2) * frequencies**2)
    return result
