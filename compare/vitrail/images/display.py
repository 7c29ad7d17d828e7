"""The one display transform: exposure in stops, clip at white, sRGB curve. For pictures, SSIM and people.

Nothing in it depends on the image: two images are always shown, and compared, under the same transform.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

LINEAR_END = 0.0031308
"""Below this the sRGB curve is a straight line [IEC 61966-2-1]."""


@dataclass(frozen=True)
class Display:
    """``display = curve(clip(radiance * 2^exposure_stops / white, 0, 1))``, in 0..1.

    ``white`` is the radiance (W sr^-1 m^-2) that is shown as full white at exposure 0.
    """

    exposure_stops: float = 0.0
    white: float = 1.0
    curve: str = "srgb"

    def apply(self, radiance: np.ndarray) -> np.ndarray:
        """Display values in 0..1 of linear radiance. Raises ValueError on NaN or infinity: a gate was left out."""
        if not np.isfinite(radiance).all():
            raise ValueError("the image holds NaN or infinity; it must fail its gate before it is shown")
        return srgb(np.clip(np.asarray(radiance, float) * (2.0**self.exposure_stops / self.white), 0.0, 1.0))

    def settings(self) -> dict[str, Any]:
        """What a metric that used this transform must state."""
        return {f"display_{key}": value for key, value in asdict(self).items()}


def srgb(linear: np.ndarray) -> np.ndarray:
    """The sRGB opto-electronic curve of values in 0..1 [IEC 61966-2-1]."""
    power = 1.055 * np.power(np.maximum(linear, LINEAR_END), 1 / 2.4) - 0.055
    return np.where(linear <= LINEAR_END, 12.92 * linear, power)


def luminance(radiance: np.ndarray) -> np.ndarray:
    """Rec. 709 luminance weights applied to the last axis; keeps the unit of the input."""
    return np.asarray(radiance) @ np.array([0.2126, 0.7152, 0.0722])
