"""What the photons of POV-Ray do differently, as entries of the certificate."""

from __future__ import annotations

from collections.abc import Iterator

from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray.bodies.curvature import curved_receivers, lost_share
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.bodies.panes import is_one_pane_deep
from vitrail.lower.povray.certificate.certificate import RELATIVE, Entry, the_light, the_material, the_object
from vitrail.lower.povray.photons.photons import Shooting, has_exact_flux
from vitrail.lower.povray.photons.stored_flux import ONE_STEP, largest_loss
from vitrail.lower.povray.text.modes import Mode, light_colours
from vitrail.lower.povray.text.sky import Skies
from vitrail.lower.povray.text.surface import is_grey
from vitrail.lower.povray.translation import Translation
from vitrail.scene.model import Ggx, Scene

ROUGH_CAUSTIC = 0.45
"""Light that bumps spread out of a caustic, by unit of lambda: behind a ball of index 1.5, in a patch of .4 radii half
edge, equation 8 leaves 3 % more at .1 (12 % by its interval), 11.9 % at .3 (12.6 %) and 22 % at .5 (28 %)."""
GGX_CAUSTIC = 0.4
"""The same by unit of alpha: 1.5 % at .06, 5.1 % at .2 (10 and 12 % by their intervals)."""
GRAZING_DEG = 84.3
"""Beyond this angle POV-Ray weighs photons by ten instead of 1 / cos [P 2.3]."""


def photon_entries(translation: Translation) -> Iterator[Entry]:
    """Storage, kernel and incidence; nothing without photons."""
    shooting = translation.shooting("a")
    if shooting is None:
        return
    scene, units, caustic = translation.scene, translation.units, Phenomenon.CAUSTIC
    yield from _stored(shooting, translation.mode)
    if translation.mode.shows_all_channels and (ratio := _channel_ratio(scene, translation.lighting.skies)) > 1:
        reason = "channels share one exponent; the dimmest is rounded down by up to a step of the brightest"
        yield Entry(caustic, "photons", "each channel apart", "one exponent", min(1.0, ratio / 128), RELATIVE, reason)
    yield Entry(
        caustic,
        "kernel",
        "irradiance at a point",
        "mean over a disc, the same in both engines",
        shooting.photons.gather_radius / units.scale,
        "m",
        "the estimate blurs by the gather radius; between the engines the blur is the same",
    )
    yield from _rough_glass(scene)
    yield from _curved_receivers(shooting, units)
    yield from _moved_lamps(shooting, units)
    yield Entry(
        caustic,
        "kernel",
        f"1 / cos beyond {GRAZING_DEG} deg",
        "10",
        GRAZING_DEG,
        "deg",
        "photons that graze a surface count too little from this angle on",
    )


def _stored(shooting: Shooting, mode: Mode) -> Iterator[Entry]:
    """What 8 bits cut off: off all caustics, and off colour that light throws through glass."""
    meant, kept = "flux in double precision", "8 bits, truncated"
    if has_exact_flux(shooting):
        reason = "the light factor makes the main path's flux exact"
        yield Entry(Phenomenon.CAUSTIC, "photons", meant, kept, 0.0, RELATIVE, reason)
        return
    reason = "fluxes vary, up to one step is lost"
    yield Entry(Phenomenon.CAUSTIC, "photons", meant, kept, ONE_STEP, RELATIVE, reason)
    glasses = [material for material in shooting.specular if material.is_transmissive]
    if all(is_grey(glass.transmission) for glass in glasses):
        return
    loss, words = ONE_STEP, "up to one step of what glass lets through is lost"
    if is_one_pane_deep(shooting.world, shooting.lights):
        loss = largest_loss(shooting, mode.exposures)
        words = "the light factor leaves all tints just above a step; light meets one pane of them alone"
    yield Entry(Phenomenon.COLOURED_TRANSMISSION, "photons", meant, kept, loss, RELATIVE, words)


def _rough_glass(scene: Scene) -> Iterator[Entry]:
    """Bumps turn slanted light farther than light that meets a face straight; equation 8 turns both alike."""
    for name, material in scene.materials.items():
        roughness = material.roughness
        if not material.is_specular or not roughness:
            continue
        is_ggx = isinstance(roughness, Ggx)
        share = GGX_CAUSTIC * roughness.ggx if isinstance(roughness, Ggx) else ROUGH_CAUSTIC * roughness
        yield Entry(
            Phenomenon.CAUSTIC,
            the_material(name),
            "GGX at every incidence" if is_ggx else "a lobe of one width at every incidence",
            "bumps, whose lobe is wider for slanted light",
            share,
            RELATIVE,
            "the light of a caustic behind a rough ball, measured; its outline differs more",
        )


def _curved_receivers(shooting: Shooting, units: Normalisation) -> Iterator[Entry]:
    for index, radius_m in curved_receivers(shooting.world):
        yield Entry(
            Phenomenon.CAUSTIC,
            the_object(shooting.world.scene, index),
            "a flat disc on a curved surface",
            "photons off the tangent plane count as farther away",
            lost_share(shooting.photons.gather_radius, units.length(radius_m)),
            RELATIVE,
            "POV-Ray stretches distances along the normal, by an absolute factor; a smaller gather radius lowers this",
        )


def _moved_lamps(shooting: Shooting, units: Normalisation) -> Iterator[Entry]:
    lights = shooting.lights
    for index in sorted({source.light for source in lights if source.aside > 0}):
        aside = max(source.aside for source in lights if source.light == index) / units.scale
        yield Entry(
            Phenomenon.CAUSTIC,
            the_light(shooting.world.scene, index),
            "a lamp in the middle of glass",
            f"a lamp {aside:.3g} m beside it, on the other side in the second half image",
            aside,
            "m",
            "POV-Ray divides the distance of photons by that of the lamp from the middle of their target",
        )


def _channel_ratio(scene: Scene, skies: Skies) -> float:
    """Brightest over dimmest channel of what photons may carry: lights times the faces of glass and mirrors."""
    lights = enumerate(scene.lights)
    colours = [colour for index, light in lights for colour in light_colours(light, skies.get(index))]
    ratio = max((max(colour) / min(colour) if min(colour) > 0 else 128.0 for colour in colours), default=1.0)
    for material in scene.materials.values():
        if material.is_specular:
            for share in (material.transmission, material.reflection):
                if max(share) > 0:
                    ratio *= (max(share) / min(share) if min(share) > 0 else 128.0) ** 2
    return ratio
