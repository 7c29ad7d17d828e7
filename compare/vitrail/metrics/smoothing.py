"""What the resolution of an image did to a number: smooth the image once more, and see how much it changes.

Photons are gathered in a disc, a pixel is a mean, and so is a cell of a patch. What smooths light once takes nearly as
much off a steep place the second time, so the change is the size of the first error, in the unit of whatever was
measured. Of each only the second moment acts on structures larger than it.
"""

from __future__ import annotations

import numpy as np
from scipy import fft

from vitrail.images.patch import PatchSamples


def smoothed_again(samples: PatchSamples, gather_radius_m: float) -> PatchSamples:
    """The samples with their light spread once more by what spread it before; light stays within the patch.

    Along each direction that is the variance of a disc, radius^2 / 4, of a pixel and of a cell, which is as large, each
    width^2 / 12. A Gaussian of their sum stands for the three, because any size of cells can hold it.
    """
    disc = gather_radius_m**2 / 4
    down = _attenuation(samples.values.shape[0], samples.cell_v_m, disc)[:, None, None]
    across = _attenuation(samples.values.shape[1], samples.cell_u_m, disc)[None, :, None]
    # The cosine transform mirrors the patch at its edges: what would leave it comes back.
    smooth = fft.idctn(fft.dctn(samples.values, axes=(0, 1)) * down * across, axes=(0, 1))
    return samples.disturbed(smooth - samples.values)


def _attenuation(cells: int, cell_m: float, disc_m2: float) -> np.ndarray:
    """What smoothing leaves of each cosine along one direction, (cells,)."""
    frequencies = np.pi * np.arange(cells) / (cells * cell_m)
    result: np.ndarray = np.exp(-0.5 * (disc_m2 + 2 * cell_m**2 / 12) * frequencies**2)
    return result
