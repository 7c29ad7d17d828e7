"""A spectrum on a receiver: where each colour falls, how far they are apart, how many separate spots there are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d
from scipy.optimize import nnls

from vitrail.base.colour import Triplet
from vitrail.images.patch import PatchSamples
from vitrail.metrics.measurement import CHANNELS, Context, Measurement, MetricError
from vitrail.metrics.profile import cell_m, degrees_at, light_of, profile

SEEN_IN = ("caustic", "refraction")
"""A spectrum lies on a receiver, or is seen through the glass."""

LEAST_SHARE = 1e-3
"""A channel or band with less than this share of the light has no centroid worth stating."""

PEAK_PROMINENCE = 0.1
"""A peak stands out by this share of the highest point of the profile after one cell of smoothing."""


@dataclass(frozen=True)
class Spectrum:
    """Profiles along the spread: positions (n,), radiance (n, 3); ``colours`` are those of the bands, by name."""

    x_m: np.ndarray
    channels: np.ndarray
    colours: Mapping[str, Triplet]
    cell_m: float

    def centroids(self) -> dict[str, float]:
        """Metres from the patch centre, by channel."""
        return self._centroids(dict(zip(CHANNELS, self.channels.T, strict=True)))

    def band_centroids(self) -> dict[str, float]:
        """Metres from the patch centre, as ``band_<name>``."""
        return self._centroids({f"band_{name}": line for name, line in self._unmixed().items()})

    def _centroids(self, lines: Mapping[str, np.ndarray]) -> dict[str, float]:
        total = self.channels.sum()
        if not total > 0:
            raise MetricError("no light of a spectrum on the patch; correct the patch, or look why it is dark")
        return {
            name: float((line * self.x_m).sum() / line.sum())
            for name, line in lines.items()
            if line.sum() > LEAST_SHARE * total
        }

    def _unmixed(self) -> dict[str, np.ndarray]:
        """The radiance of each band at each position: the nearest non-negative mixture of band colours.

        Exact where neighbouring bands do not overlap. Where they do, four colours in three channels have no one answer:
        red over green, for one, is yellow.
        """
        if not self.colours:
            return {}
        colours = np.array(list(self.colours.values()), float).T
        shares = np.array([nnls(colours, np.maximum(row, 0.0))[0] for row in self.channels])
        return dict(zip(self.colours, shares.T, strict=True))

    def spread_m(self) -> float:
        """From the red centroid to the blue one, signed along the patch."""
        places = self.centroids()
        if "red" not in places or "blue" not in places:
            raise MetricError("the spectrum has no red or no blue; no spread can be measured")
        return places["blue"] - places["red"]

    def rms_width_m(self) -> float:
        """Root mean square distance from the centroid, mean of the channels."""
        grey = self.channels.mean(axis=-1)
        middle = (grey * self.x_m).sum() / grey.sum()
        variance = (grey * (self.x_m - middle) ** 2).sum() / grey.sum()
        return float(np.sqrt(max(variance, 0.0)))

    def peaks(self) -> int:
        """The number of separate maxima of the mean of the channels."""
        # Load SciPy's signals where there are peaks to count: that takes as long as all else of this file.
        from scipy.signal import find_peaks

        smooth = gaussian_filter1d(np.pad(self.channels.mean(axis=-1), 3), 1.0)
        return int(find_peaks(smooth, prominence=PEAK_PROMINENCE * smooth.max())[0].size)


def spectrum_places(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Centroids along the spread by channel and by band.

    Absolute: ``place.<name>`` in metres and, with ``context.throw_m``, ``place_deg.<name>``; comparison:
    ``place_shift.<name>`` in metres, ideal 0.
    """
    ours, theirs, rest = _spectra(candidate, reference, context)
    places = ours.centroids() | ours.band_centroids()
    if theirs is None:
        found = [Measurement(f"place.{n}", x, "m", None, **rest) for n, x in places.items()]
        if context.throw_m is not None:
            throw = context.throw_m
            found += [
                Measurement(f"place_deg.{n}", degrees_at(x, throw), "deg", None, **rest) for n, x in places.items()
            ]
        return found
    others = theirs.centroids() | theirs.band_centroids()
    return [Measurement(f"place_shift.{n}", x - others[n], "m", 0.0, **rest) for n, x in places.items() if n in others]


def spectrum_spread(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Distance from red to blue, and the width of the whole.

    Absolute: ``spread`` and ``rms_width`` in metres, ``spread_deg`` with ``context.throw_m``. Comparison:
    ``spread_ratio`` (negative when the colours are in the wrong order) and ``rms_width_ratio``, ideal 1.
    """
    ours, theirs, rest = _spectra(candidate, reference, context)
    spread, width = ours.spread_m(), ours.rms_width_m()
    if theirs is None:
        found = [Measurement("spread", spread, "m", None, **rest), Measurement("rms_width", width, "m", None, **rest)]
        if context.throw_m is not None:
            places = ours.centroids()
            degrees = degrees_at(places["blue"], context.throw_m) - degrees_at(places["red"], context.throw_m)
            found.append(Measurement("spread_deg", degrees, "deg", None, **rest))
        return found
    other_spread, other_width = theirs.spread_m(), theirs.rms_width_m()
    # A reference without a spread leaves nothing to divide by; half a cell is what a centroid surely resolves.
    if abs(other_spread) < theirs.cell_m / 2 or other_width == 0:
        raise MetricError("the reference shows no spread; compare its place only, or correct the patch")
    parts = {"candidate": spread, "reference": other_spread}
    width_parts = {"candidate": width, "reference": other_width}
    return [
        Measurement("spread_ratio", spread / other_spread, "1", 1.0, parts=parts, **rest),
        Measurement("rms_width_ratio", width / other_width, "1", 1.0, parts=width_parts, **rest),
    ]


def colour_order(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Whether the colours run the same way, and the number of separate spots (banding).

    Absolute: ``peaks`` and ``colour_order`` (+1 when red to blue runs along the patch, -1 against it). Comparison:
    ``peak_difference`` with ideal 0 and ``colour_order_agreement`` with ideal 1. Counts have no interval.
    """
    ours, theirs, rest = _spectra(candidate, reference, context)
    order = float(np.sign(ours.spread_m()))
    if theirs is None:
        return [
            Measurement("colour_order", order, "1", None, **rest),
            Measurement("peaks", float(ours.peaks()), "1", None, **rest),
        ]
    parts = {"candidate": ours.peaks(), "reference": theirs.peaks()}
    return [
        Measurement("colour_order_agreement", order * float(np.sign(theirs.spread_m())), "1", 1.0, **rest),
        Measurement("peak_difference", float(ours.peaks() - theirs.peaks()), "1", 0.0, parts=parts, **rest),
    ]


def _spectra(
    candidate: PatchSamples, reference: PatchSamples | None, context: Context
) -> tuple[Spectrum, Spectrum | None, dict]:
    light, other = light_of(SEEN_IN, candidate, reference, context)
    rest = {"settings": {**light.settings, "along": context.along}, "caveats": light.caveats}
    ours = _spectrum(light.values, candidate, context)
    return ours, None if reference is None or other is None else _spectrum(other.values, reference, context), rest


def _spectrum(values: np.ndarray, samples: PatchSamples, context: Context) -> Spectrum:
    x, channels = profile(values, samples, context.along)
    return Spectrum(x, channels, context.bands, cell_m(samples, context.along))
