"""The penumbra of a straight edge under a square Lambertian lamp, by integrating the part of the lamp that is seen."""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq

NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)


class Penumbra:
    """A lamp of half width ``lamp`` at ``height`` over a floor, a cover of x < 0 at ``edge``; a square patch ``half``.

    Lengths in metres; irradiance in units of the lamp's radiance.
    """

    def __init__(self, lamp: float, height: float, edge: float, half: float) -> None:
        self.lamp, self.height, self.edge, self.half = lamp, height, edge, half

    def irradiance(self, x: float) -> float:
        """Mean over the patch's width of E(x, z): h^2 / d^4 over the lamp's part that the cover leaves in sight."""
        # The line from x on the floor to s on the lamp passes the cover's height at x + (s - x) edge / height > 0.
        first = max(-self.lamp, -x * (self.height - self.edge) / self.edge)
        if first >= self.lamp:
            return 0.0
        s = (self.lamp + first) / 2 + (self.lamp - first) / 2 * NODES
        along = (s - x)[:, None, None] ** 2
        across = (self.lamp * NODES[:, None] - self.half * NODES[None, :])[None, :, :] ** 2
        field = self.height**2 / (along + across + self.height**2) ** 2
        summed = np.einsum("i,j,k,ijk->", WEIGHTS, WEIGHTS, WEIGHTS / 2, field)
        return float(summed * (self.lamp - first) / 2 * self.lamp)

    def plateau(self, side: int, share: float) -> float:
        """Mean irradiance over the outer ``share`` of the patch at one side, as the metric takes it."""
        middle, reach = side * self.half * (1 - share), self.half * share
        return float(sum(w / 2 * self.irradiance(middle + reach * x) for x, w in zip(NODES, WEIGHTS, strict=True)))

    def crossing(self, level: float, share: float = 0.15) -> float:
        dark, lit = self.plateau(-1, share), self.plateau(1, share)
        target = dark + level * (lit - dark)
        return float(brentq(lambda x: self.irradiance(x) - target, -self.half, self.half, xtol=1e-14))

    def width(self) -> float:
        """From 10 % to 90 % of the step between the plateaus."""
        return self.crossing(0.9) - self.crossing(0.1)
