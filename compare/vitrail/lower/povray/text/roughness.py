"""Rough faces as bumps far smaller than a pixel: POV-Ray has no microfacets, but it turns normals [P 5].

``bumps A`` tilts the normal by 0.387 A radians (root mean square), nearly a Rayleigh distribution. The paper's and the
GGX lobes are mixtures of such ones: given a uniform u, equation 8 deflects by s g(u) with g = gamma / (1 - gamma),
gamma = u lambda / 2, and the square of a GGX slope is alpha^2 E / -ln(u) with E exponential. Rayleigh lobes are more
pointed than s, which has a largest value, so the mixture of equation 8 leans to its wider ones. So a pattern of cells,
each with its own random number, chooses the amplitude at every point. Refraction turns a tilt into a smaller
deflection, (1 - 1/n) on the way in and (n - 1) on the way out, so the inside of a face has bumps of its own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import assert_never

from vitrail.lower.povray.text.sdl import Block, MapEntry, block, statement
from vitrail.scene.model import Ggx, Material

TILT_PER_AMPLITUDE = 0.387
"""Root mean square tilt, radians, of ``bumps 1`` [P 5]."""
MEAN_SQUARE_S = 2 / 3
"""Of the part of a random unit vector that is across a direction [O 1.3]."""
FULL, LEAN = 0.95, 0.8
"""Deflections of the mixture are FULL * G * (g / G)^LEAN, G the largest g: fitted to the profile of a blurred edge.

An edge then has it to 0.7 % of the step behind a pane and 1 % behind one face; with 1 and 1 to 1.9 and 2.4 %.
"""
WIDEST_TILT = 1.0
"""Radians, root mean square, beyond which bumps no longer say what they should."""
LEVELS = 16
"""Amplitudes in the mixture."""
CELL_SHARE = 1.23e-4
BUMP_SIZE = 0.31
"""Share of the scene's extent, and of a cell: far below a pixel, and no multiple of anything on the grid."""
HALF_SHIFT = {"a": 0.0, "b": 0.0713}
"""Share of the extent by which a half image moves its cells in x, y and z: hundreds of them, and no whole number."""


@dataclass(frozen=True)
class Bumps:
    """The amplitudes that cells choose from, each as often as the others."""

    amplitudes: tuple[float, ...]

    @property
    def mean_tilt(self) -> float:
        """Median over the mixture of the tilt's root mean square, radians; a mean would not exist for GGX."""
        return TILT_PER_AMPLITUDE * sorted(self.amplitudes)[LEVELS // 2]

    def sdl(self, extent: float, half: str) -> Block:
        """A ``normal`` block whose map has a step for each amplitude, in a scene of ``extent`` units.

        The half images have other cells and other bumps, so that their difference is the noise of the pattern, too.
        """
        steps = []
        for level, amplitude in enumerate(self.amplitudes):
            bumps = (statement("bumps", amplitude), statement("scale", BUMP_SIZE))
            steps += [MapEntry(level / LEVELS, bumps), MapEntry((level + 1) / LEVELS, bumps)]
        cell = statement("scale", CELL_SHARE * extent)
        moved = statement("translate", HALF_SHIFT[half] * extent)
        return block("normal", statement("cells"), block("normal_map", *steps), cell, moved)


def bumps_of(material: Material, index: float, *, from_inside: bool) -> Bumps | None:
    """The bumps of a face as rays from outside or inside meet it; None for a smooth one."""
    roughness = material.roughness
    match roughness:
        case Ggx():
            tilts = [roughness.ggx / math.sqrt(-math.log(u)) for u in _midpoints()]
        case float() | int():
            if roughness == 0:
                return None
            gammas = [u * roughness / 2 for u in _midpoints()]
            largest = roughness / 2 / (1 - roughness / 2)
            shares = [gamma / (1 - gamma) / largest for gamma in gammas]
            deflections = [math.sqrt(MEAN_SQUARE_S) * FULL * largest * share**LEAN for share in shares]
            tilts = [deflection / tilt_to_deflection(material, index, from_inside) for deflection in deflections]
        case _:
            assert_never(roughness)
    return Bumps(tuple(tilt / TILT_PER_AMPLITUDE for tilt in tilts))


def tilt_to_deflection(material: Material, index: float, from_inside: bool) -> float:
    """How far a way on turns for a small tilt of the normal; a mirror doubles it."""
    if not material.is_transmissive:
        return 2.0
    return abs(index - 1) if from_inside else abs(1 - 1 / index)


def _midpoints() -> list[float]:
    return [(level + 0.5) / LEVELS for level in range(LEVELS)]
