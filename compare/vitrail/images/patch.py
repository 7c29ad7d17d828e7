"""Resample an image onto a world-space patch, so that every number is in metres and watts and not in pixels.

Radiance runs linearly across a pixel, about its mean and with the slope between its two neighbours; a cell of the
patch is the mean of what it covers. So flux is conserved, a gradient is kept, and a patch whose edges lie on pixel
edges of an axis-aligned orthographic view returns the pixels unchanged.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from scipy import sparse

from vitrail.geometry.camera import View
from vitrail.scene.model import Camera, Image, Patch

SUPERSAMPLES = 4
"""Points a cell has along each edge where the view is not axis-aligned."""

MOST_CELLS = 1024
"""Cells a patch has at most along one edge; a finer image is averaged into them, nothing is dropped."""


@dataclass(frozen=True)
class PatchSamples:
    """Radiance on a regular grid of the patch; row index grows with v, column index with u.

    ``values`` (nv, nu, 3), W sr^-1 m^-2; ``half_a`` and ``half_b`` are two independent renderings whose mean it is, or
    None. ``layers`` split ``values`` by phenomenon. ``u_m`` and ``v_m`` are cell centres relative to the patch centre.
    ``coverage`` (nv, nu) is the share of a cell that is inside the frame; uncovered cells hold 0.
    """

    values: np.ndarray
    half_a: np.ndarray | None
    half_b: np.ndarray | None
    u_m: np.ndarray
    v_m: np.ndarray
    cell_area_m2: float
    coverage: np.ndarray
    layers: Mapping[str, np.ndarray] = field(default_factory=dict)

    @property
    def cell_u_m(self) -> float:
        return float(self.u_m[1] - self.u_m[0]) if self.u_m.size > 1 else self.cell_area_m2 / self.cell_v_m

    @property
    def cell_v_m(self) -> float:
        return float(self.v_m[1] - self.v_m[0]) if self.v_m.size > 1 else float(np.sqrt(self.cell_area_m2))

    @property
    def noise(self) -> np.ndarray | None:
        """One realisation of the noise of ``values``: (half_a - half_b) / 2 has the same law and mean 0."""
        return None if self.half_a is None or self.half_b is None else (self.half_a - self.half_b) / 2

    def disturbed(self, offset: np.ndarray) -> PatchSamples:
        """These samples with ``offset`` added to the radiance, and to every layer as if all of it were that layer's.

        Halves are known of the whole radiance only, so the noise of a layer is taken for at most that of the whole.
        """
        layers = {name: layer + offset for name, layer in self.layers.items()}
        return replace(self, values=self.values + offset, layers=layers)


@dataclass(frozen=True)
class PatchGrid:
    """The linear map from the pixels of one view to the cells of one patch; make it once, apply it to every array."""

    u_m: np.ndarray
    v_m: np.ndarray
    cell_area_m2: float
    coverage: np.ndarray
    weights: sparse.csr_matrix
    """(cells, pixels); the weights of a cell sum to its coverage."""

    def apply(self, array: np.ndarray) -> np.ndarray:
        """(height, width, 3) to (nv, nu, 3); a cell half in frame is the mean of the half that is."""
        flat = np.asarray(array, float).reshape(-1, array.shape[-1])
        seen = np.maximum(self.coverage.reshape(-1, 1), np.finfo(float).tiny)
        return ((self.weights @ flat) / seen).reshape(self.v_m.size, self.u_m.size, -1)


def make_grid(camera: Camera, image: Image, patch: Patch, *, supersamples: int = SUPERSAMPLES) -> PatchGrid:
    """The grid of a patch at about one cell a pixel."""
    view = View.of(camera, image)
    center, u, v = (np.asarray(vector, float) for vector in (patch.center, patch.u, patch.v))
    half_u, half_v = float(np.linalg.norm(u)), float(np.linalg.norm(v))
    n_u, n_v = _cells_along(view, center, u), _cells_along(view, center, v)
    u_m = (np.arange(n_u) + 0.5) * (2 * half_u / n_u) - half_u
    v_m = (np.arange(n_v) + 0.5) * (2 * half_v / n_v) - half_v
    separable = _separable_weights(view, center, u, v, n_u, n_v)
    weights = separable if separable is not None else _sampled_weights(view, center, u, v, n_u, n_v, supersamples)
    # Rounding of edges may leave a coverage of 1 + 1e-16; it is a share.
    coverage = np.minimum(np.asarray(weights.sum(axis=1)).reshape(n_v, n_u), 1.0)
    return PatchGrid(u_m, v_m, 4 * half_u * half_v / (n_u * n_v), coverage, weights)


def sample_patch(
    radiance: np.ndarray,
    camera: Camera,
    image: Image,
    patch: Patch,
    *,
    half_a: np.ndarray | None = None,
    half_b: np.ndarray | None = None,
    layers: Mapping[str, np.ndarray] | None = None,
    grid: PatchGrid | None = None,
) -> PatchSamples:
    """Radiance (height, width, 3), its halves and its layers on the cells of ``patch``. Raises ValueError on a size
    that is not the image's."""
    arrays = [radiance, *(a for a in (half_a, half_b) if a is not None), *(layers or {}).values()]
    for array in arrays:
        if array.shape != (image.height, image.width, 3):
            raise ValueError(
                f"image is {array.shape}, the scene says {(image.height, image.width, 3)}; render it again"
            )
    grid = grid or make_grid(camera, image, patch)
    return PatchSamples(
        values=grid.apply(radiance),
        half_a=None if half_a is None else grid.apply(half_a),
        half_b=None if half_b is None else grid.apply(half_b),
        u_m=grid.u_m,
        v_m=grid.v_m,
        cell_area_m2=grid.cell_area_m2,
        coverage=grid.coverage,
        layers={name: grid.apply(array) for name, array in (layers or {}).items()},
    )


def _cells_along(view: View, center: np.ndarray, half_edge: np.ndarray) -> int:
    """The number of pixels the patch spans along one edge, at its centre."""
    step = 1e-3
    x, y, _ = view.project(np.stack([center - step * half_edge, center + step * half_edge]))
    pixels = float(np.hypot(x[1] - x[0], y[1] - y[0])) / step
    # Leave numbers that are whole but for rounding alone, so that an aligned patch maps pixel to cell.
    return int(np.clip(round(pixels), 1, MOST_CELLS)) if np.isfinite(pixels) else 1


def _separable_weights(
    view: View, center: np.ndarray, u: np.ndarray, v: np.ndarray, n_u: int, n_v: int
) -> sparse.csr_matrix | None:
    """Exact means, where the edges of the patch run along rows and columns of an orthographic view; else None."""
    if view.perspective:
        return None
    x, y, _ = view.project(np.stack([center - u, center + u, center - v, center + v]))
    along = np.array([[x[1] - x[0], y[1] - y[0]], [x[3] - x[2], y[3] - y[2]]])
    size = np.abs(along).max()
    if abs(along[0, 1]) < 1e-9 * size and abs(along[1, 0]) < 1e-9 * size:
        columns = _overlaps(x[0], x[1], n_u, view.width)
        rows = _overlaps(y[2], y[3], n_v, view.height)
        return sparse.csr_matrix(sparse.kron(rows, columns))
    if abs(along[0, 0]) < 1e-9 * size and abs(along[1, 1]) < 1e-9 * size:
        rows = _overlaps(y[0], y[1], n_u, view.height)
        columns = _overlaps(x[2], x[3], n_v, view.width)
        # Cell (i_v, i_u) takes column weights of i_v and row weights of i_u: pair them and put the pixels in order.
        swapped = sparse.kron(columns, rows)
        order = np.arange(view.height * view.width).reshape(view.width, view.height).T.ravel()
        return sparse.csr_matrix(sparse.csc_matrix(swapped)[:, order])
    return None


def _overlaps(start: float, stop: float, cells: int, pixels: int) -> sparse.csr_matrix:
    """(cells, pixels): the weight of each pixel [i, i + 1] in the mean over each cell of [start, stop]."""
    edges = np.linspace(start, stop, cells + 1)
    # An edge within 1e-9 of a pixel's edge is that edge: the difference is rounding of the scene's decimals.
    edges = np.where(np.abs(edges - np.round(edges)) < 1e-9 * pixels, np.round(edges), edges)
    low, high = np.minimum(edges[:-1], edges[1:])[:, None], np.maximum(edges[:-1], edges[1:])[:, None]
    pixel = np.arange(pixels)[None, :]
    first, last = np.maximum(low, pixel), np.minimum(high, pixel + 1)
    overlap = np.clip(last - first, 0, None)
    # What a cell takes of one side of a pixel's middle weighs the slope, half of (next - previous).
    lean = overlap * ((first + last) / 2 - (pixel + 0.5)) / 2
    lean[:, [0, -1]] = 0
    overlap[:, 1:] += lean[:, :-1]
    overlap[:, :-1] -= lean[:, 1:]
    return sparse.csr_matrix(overlap / (high - low))


def _sampled_weights(
    view: View, center: np.ndarray, u: np.ndarray, v: np.ndarray, n_u: int, n_v: int, supersamples: int
) -> sparse.csr_matrix:
    """The weight of each pixel in the mean of ``supersamples`` squared points of each cell."""
    a = (np.arange(n_u * supersamples) + 0.5) / (n_u * supersamples) * 2 - 1
    b = (np.arange(n_v * supersamples) + 0.5) / (n_v * supersamples) * 2 - 1
    # Go row by row of cells: the points of a large patch would not fit in memory at once.
    rows = [
        _row_weights(view, center + a[None, :, None] * u + b_row[:, None, None] * v, n_u)
        for b_row in b.reshape(n_v, supersamples)
    ]
    return sparse.csr_matrix(sparse.vstack(rows))


def _row_weights(view: View, points: np.ndarray, n_u: int) -> sparse.csr_matrix:
    """(n_u, pixels) of one row of cells, seen at ``points`` (supersamples, n_u * supersamples, 3)."""
    supersamples = points.shape[0]
    x, y, depth = view.project(points)
    seen = (depth > 0) & (x >= 0) & (x < view.width) & (y >= 0) & (y < view.height)
    cell = np.broadcast_to(np.arange(points.shape[1]) // supersamples, x.shape)[seen]
    column, row = np.floor(x[seen]).astype(np.int64), np.floor(y[seen]).astype(np.int64)
    pixel = row * view.width + column
    # The slope to either side of a pixel, none at the frame where a neighbour is missing.
    lean_x = np.where((column > 0) & (column < view.width - 1), x[seen] - column - 0.5, 0) / 2
    lean_y = np.where((row > 0) & (row < view.height - 1), y[seen] - row - 0.5, 0) / 2
    share = np.concatenate([np.ones(pixel.size), lean_x, -lean_x, lean_y, -lean_y]) / supersamples**2
    step_x, step_y = (lean_x != 0).astype(np.int64), (lean_y != 0).astype(np.int64) * view.width
    pixels = np.concatenate([pixel, pixel + step_x, pixel - step_x, pixel + step_y, pixel - step_y])
    shape = (n_u, view.width * view.height)
    return sparse.csr_matrix((share, (np.tile(cell, 5), pixels)), shape=shape)
