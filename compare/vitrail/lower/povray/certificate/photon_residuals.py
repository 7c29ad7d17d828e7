"""What the photons of POV-Ray do differently, as entries of the certificate."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.curvature import curved_receivers, lost_share
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.bodies.panes import is_one_pane_deep
from vitrail.lower.povray.certificate.certificate import RELATIVE, Entry
from vitrail.lower.povray.photons.photons import PhotonPass, has_exact_flux
from vitrail.lower.povray.photons.stored_flux import ONE_STEP, largest_loss
from vitrail.lower.povray.text.lights import Source
from vitrail.lower.povray.text.modes import Mode, light_colours
from vitrail.lower.povray.text.sky import Skies
from vitrail.lower.povray.text.surface import is_grey
from vitrail.scene.model import Ggx, Scene

ROUGH_CAUSTIC = 0.45
"""Light that bumps spread out of a caustic, by unit of lambda: behind a ball of index 1.5, in a patch of .4 radii half
edge, equation 8 leaves 3 % more at .1 (12 % by its interval), 11.9 % at .3 (12.6 %) and 22 % at .5 (28 %)."""
GGX_CAUSTIC = 0.4
"""The same by unit of alpha: 1.5 % at .06, 5.1 % at .2 (10 and 12 % by their intervals)."""
GRAZING_DEG = 84.3
"""Beyond this angle POV-Ray weighs photons by ten instead of 1 / cos [P 2.3]."""


def photon_entries(
    world: World, mode: Mode, units: Normalisation, lights: Sequence[Source], skies: Skies, photons: PhotonPass | None
) -> Iterator[Entry]:
    """Storage, kernel and incidence; nothing without photons."""
    if photons is None:
        return
    scene, caustic = world.scene, Phenomenon.CAUSTIC
    yield from _stored(world, mode, lights, photons)
    if mode.shows_all_channels and (ratio := _channel_ratio(scene, skies)) > 1:
        reason = "channels share one exponent; the dimmest is rounded down by up to a step of the brightest"
        yield Entry(caustic, "photons", "each channel apart", "one exponent", min(1.0, ratio / 128), RELATIVE, reason)
    yield Entry(
        caustic,
        "kernel",
        "irradiance at a point",
        "mean over a disc, the same in both engines",
        photons.gather_radius / units.scale,
        "m",
        "the estimate blurs by the gather radius; between the engines the blur is the same",
    )
    yield from _rough_glass(scene)
    yield from _curved_receivers(world, units, photons)
    yield from _moved_lamps(units, lights)
    yield Entry(
        caustic,
        "kernel",
        f"1 / cos beyond {GRAZING_DEG} deg",
        "10",
        GRAZING_DEG,
        "deg",
        "photons that graze a surface count too little from this angle on",
    )


def _stored(world: World, mode: Mode, lights: Sequence[Source], photons: PhotonPass) -> Iterator[Entry]:
    """What 8 bits cut off: off all caustics, and off colour that light throws through glass."""
    item, meant, kept = "photons", "flux in double precision", "8 bits, truncated"
    if has_exact_flux(world, lights, photons):
        reason = "the light factor makes the main path's flux exact"
        yield Entry(Phenomenon.CAUSTIC, item, meant, kept, 0.0, RELATIVE, reason)
        return
    reason = "fluxes vary, up to one step is lost"
    yield Entry(Phenomenon.CAUSTIC, item, meant, kept, ONE_STEP, RELATIVE, reason)
    scene = world.scene
    glasses = [scene.material_of(item) for item in scene.objects if scene.material_of(item).is_transmissive]
    if all(is_grey(glass.transmission) for glass in glasses):
        return
    loss, words = ONE_STEP, "up to one step of what glass lets through is lost"
    if is_one_pane_deep(world, lights):
        loss = largest_loss(scene, lights, photons, mode.exposures)
        words = "the light factor leaves all tints just above a step; light meets one pane of them alone"
    yield Entry(Phenomenon.COLOURED_TRANSMISSION, item, meant, kept, loss, RELATIVE, words)


def _rough_glass(scene: Scene) -> Iterator[Entry]:
    """Bumps turn slanted light farther than light that meets a face straight; equation 8 turns both alike."""
    for number, material in enumerate(scene.materials.values(), 1):
        roughness = material.roughness
        if not material.is_specular or not roughness:
            continue
        is_ggx = isinstance(roughness, Ggx)
        share = GGX_CAUSTIC * roughness.ggx if isinstance(roughness, Ggx) else ROUGH_CAUSTIC * roughness
        yield Entry(
            Phenomenon.CAUSTIC,
            f"M{number}",
            "GGX at every incidence" if is_ggx else "a lobe of one width at every incidence",
            "bumps, whose lobe is wider for slanted light",
            share,
            RELATIVE,
            "the light of a caustic behind a rough ball, measured; its outline differs more",
        )


def _curved_receivers(world: World, units: Normalisation, photons: PhotonPass) -> Iterator[Entry]:
    for index, radius_m in curved_receivers(world):
        yield Entry(
            Phenomenon.CAUSTIC,
            f"O{index + 1}",
            "a flat disc on a curved surface",
            "photons off the tangent plane count as farther away",
            lost_share(photons.gather_radius, units.length(radius_m)),
            RELATIVE,
            "POV-Ray stretches distances along the normal, by an absolute factor; a smaller gather radius lowers this",
        )


def _moved_lamps(units: Normalisation, lights: Sequence[Source]) -> Iterator[Entry]:
    for index in sorted({source.light for source in lights if source.aside > 0}):
        aside = max(source.aside for source in lights if source.light == index) / units.scale
        yield Entry(
            Phenomenon.CAUSTIC,
            f"L{index + 1}",
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
