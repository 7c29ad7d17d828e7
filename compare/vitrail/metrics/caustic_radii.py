"""How tightly light is gathered: the circles about its centre that hold half and nine tenths of it."""

from __future__ import annotations

import numpy as np

from vitrail.images.patch import PatchSamples
from vitrail.metrics.caustic import centre_of
from vitrail.metrics.encircled import encircled, encircled_again, room_about
from vitrail.metrics.measurement import Context, Measurement, PatchMetric
from vitrail.metrics.profile import light_of

SHARES = {"r50": 0.5, "r90": 0.9}
"""The radii of a caustic by name, with the share of the flux within each."""


def caustic_radii(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> list[Measurement]:
    """Radii that hold 50 % and 90 % of the flux on the largest circle about the centre: ``r50``, ``r90`` in metres,
    or ``r50_ratio``, ``r90_ratio`` with ideal 1.

    The centre is ``context.centre_m``, or else the centroid of the reference, for both images the same.
    """
    light, other = light_of(("caustic",), candidate, reference, context)
    centre = centre_of(light if other is None else other, candidate if reference is None else reference, context)
    outer = min(room_about(candidate, centre), context.outer_radius_m or np.inf)
    settings = {**light.settings, "centre_m": centre, "outer_radius_m": outer}
    ours = encircled(light.values.mean(axis=-1), candidate, centre, outer)
    found = []
    for name, share in SHARES.items():
        radius = ours.radius_of(share)
        if reference is None or other is None:
            found.append(Measurement(name, radius, "m", None, settings, caveats=light.caveats))
            continue
        truth = encircled(other.values.mean(axis=-1), reference, centre, outer).radius_of(share)
        parts = {"candidate": radius, "reference": truth}
        found.append(Measurement(f"{name}_ratio", radius / truth, "1", 1.0, settings, parts, light.caveats))
    return found


def caustic_radii_near(candidate: PatchSamples, reference: PatchSamples | None, context: Context) -> PatchMetric:
    """``caustic_radii`` of images that differ little from these, without new rings for every centre.

    The light within each circle is counted anew about the centre of these images; what the centre's own move does to
    a radius is taken as proportional to it.
    """
    light, other = light_of(("caustic",), candidate, reference, context)
    centre = centre_of(light if other is None else other, candidate if reference is None else reference, context)
    room = room_about(candidate, centre)
    images = [(candidate, light)] if reference is None or other is None else [(candidate, light), (reference, other)]
    slopes = {
        (side, share): _radius_slope(lit.values.mean(axis=-1), image, centre, share, context)
        for side, (image, lit) in enumerate(images)
        for share in SHARES.values()
    }

    def again(ours: PatchSamples, theirs: PatchSamples | None, known: Context) -> list[Measurement]:
        lights = [each for each in light_of(("caustic",), ours, theirs, known) if each is not None]
        patches = [each for each in (ours, theirs) if each is not None]
        moved = np.subtract(centre_of(lights[-1], patches[-1], known), centre)
        outer = min(room_about(ours, (centre[0] + moved[0], centre[1] + moved[1])), known.outer_radius_m or np.inf)
        found = []
        for name, share in SHARES.items():
            radii = [
                encircled_again(lit.values.mean(axis=-1), patch, centre, room).radius_of(share, min(outer, room))
                + float(slopes[side, share] @ moved)
                for side, (lit, patch) in enumerate(zip(lights, patches, strict=True))
            ]
            if len(radii) == 1:
                found.append(Measurement(name, radii[0], "m"))
            else:
                found.append(Measurement(f"{name}_ratio", radii[0] / radii[1], "1"))
        return found

    return again


def _radius_slope(
    light: np.ndarray, samples: PatchSamples, centre: tuple[float, float], share: float, context: Context
) -> np.ndarray:
    """How a radius changes when the centre moves along u and v, (2,), the outermost circle keeping its size."""
    if context.centre_m is not None:
        return np.zeros(2)
    steps = np.array([[samples.cell_u_m, 0.0], [0.0, samples.cell_v_m]])
    places = [(centre[0] + sign * step[0], centre[1] + sign * step[1]) for step in steps for sign in (-1, 1)]
    outer = min([room_about(samples, place) for place in places] + [context.outer_radius_m or np.inf])
    radii = [encircled(light, samples, place, outer).radius_of(share) for place in places]
    return np.array([radii[1] - radii[0], radii[3] - radii[2]]) / (2 * np.array([samples.cell_u_m, samples.cell_v_m]))
