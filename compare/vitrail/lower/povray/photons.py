"""The photon pass: spacing, kernel, and a light factor that keeps every photon exact.

POV-Ray stores a photon's flux in 8 bits a channel, truncated, and loses it silently at 32 [P 2.4]. With a spacing that
is a power of two and a light factor that makes the flux of the main path a power of two, nothing is truncated. The
second half image needs another pattern of photons: its spacing is smaller by sqrt(181 / 256), so that the flux has the
mantissa 181 / 256, which is exact too.

The kernel is the flat disc of fixed radius that the tracer uses: ``radius R`` with ``gather 0, many``, which neither
shrinks to the nearest photons nor grows where there are few [P 2.3]. Photons are shot in one execution, which saves
them, and used in a second one, because the engine must order POV-Ray's search tree in between.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from vitrail.lower.povray.exposure import Exposure
from vitrail.lower.povray.lights import Source
from vitrail.lower.povray.normalise import Normalisation
from vitrail.lower.povray.refusal import NotTranslatable, Refusals
from vitrail.lower.povray.sdl import block, number
from vitrail.plan.bounds import Bounds, bounds_of
from vitrail.plan.budget import Settings
from vitrail.plan.plan import Plan
from vitrail.scene.model import Material, Scene
from vitrail.scene.phenomenon import Phenomenon
from vitrail.scene.vector import Vec, length, subtract

FLUX_LIMIT = 16.0
"""Largest flux of one photon; POV-Ray loses photons at 32 without a word [P 2.4]."""
SECOND_MANTISSA = 181 / 256
"""Flux of the second half's photons over the first's; its root, 0.841, is far from any ratio of small numbers."""
ABOVE_THE_STEP = 1 + 2e-6
"""Lifts a flux over its truncation step by more than single precision may lower it."""
JITTER = 0.4
"""POV-Ray's default: each photon moves by up to a fifth of a cell."""
PHOTON_FILE = "photons.map"
"""The saved map, in the folder of the run; the only file name in a scene text, and ours."""
MOST_GATHERED = 1 << 20
"""Photons in one disc before POV-Ray would shrink it; far more than any disc of the supported budgets holds."""


@dataclass(frozen=True)
class PhotonPass:
    """Spacing of the two halves and radius of the kernel, units."""

    spacing: dict[str, float]
    gather_radius: float
    expected_shot: float

    def sdl(self, half: str, file: str) -> str:
        """The photons block of one half; ``file`` is what happens to the map: ``save_file`` or ``load_file``."""
        return block(
            "photons",
            [
                f"spacing {number(self.spacing[half])}",
                f"radius {number(self.gather_radius)}",
                f"gather 0, {MOST_GATHERED}",
                "expand_thresholds 0, 0",
                f"jitter {number(JITTER)}",
                "autostop 1",
                f'{file} "{PHOTON_FILE}"',
            ],
        )


def photon_pass(
    scene: Scene, plan: Plan, settings: Settings, lights: Sequence[Source], units: Normalisation, refusals: Refusals
) -> PhotonPass | None:
    """The photon pass of a scene, or None when the plan has no caustic."""
    if not plan.requires(Phenomenon.CAUSTIC) or settings.photons == 0:
        return None
    balls = target_balls(scene, units, refusals)
    area = sum(_aimed_area(source, centre, radius) for source in lights for centre, radius in balls)
    # Share the photons of the settings between the two halves.
    both = 1 + 1 / SECOND_MANTISSA
    spacing = 2.0 ** round(math.log2(math.sqrt(area * both / settings.photons)))
    return PhotonPass(
        spacing={"a": spacing, "b": spacing * math.sqrt(SECOND_MANTISSA)},
        gather_radius=units.length(settings.gather_radius_m),
        expected_shot=area / spacing**2,
    )


def target_balls(scene: Scene, units: Normalisation, refusals: Refusals) -> list[tuple[Vec, float]]:
    """Centre and radius, units, of the ball around the box of each specular object: where POV-Ray aims photons."""
    balls, refused = [], []
    for index, item in enumerate(scene.objects):
        if not scene.material_of(item).is_specular:
            continue
        bounds = bounds_of(item)
        if not bounds.is_finite:
            what = f"POV-Ray cannot aim photons at an infinite {item.shape_key}"
            refused.append(refusals.at(what, "use a rectangle, a disc or a box", "objects", index, item.shape_key))
            continue
        balls.append(_ball(bounds, units))
    if refused:
        raise NotTranslatable(refused)
    return balls


def _ball(bounds: Bounds, units: Normalisation) -> tuple[Vec, float]:
    return units.point(bounds.centre), units.length(bounds.radius_m)


def _aimed_area(source: Source, centre: Vec, radius: float) -> float:
    """Area at the target over which photons are spread, units squared."""
    if source.direction is not None:
        return math.pi * radius**2
    distance = length(subtract(centre, source.position))
    if distance <= radius:
        return 4 * math.pi * radius**2
    half_angle = math.asin(radius / distance)
    return 2 * math.pi * (1 - math.cos(half_angle)) * distance**2


def light_factor(
    scene: Scene, lights: Sequence[Source], photons: PhotonPass | None, exposure: Exposure, units: Normalisation
) -> float:
    """The factor on all light of a run: images near 1, and photons whose flux has a short mantissa.

    Without photons it is a power of two, so that undoing it loses nothing.
    """
    brightest = max((max(exposure.share(source.strength)) for source in lights), default=0.0)
    glow = max((max(exposure.share(_peak(m))) for m in scene.materials.values() if m.emission is not None), default=0.0)
    peak = max(brightest * _at_one_unit(lights), glow)
    if peak == 0:
        return 1.0
    factor = 2.0 ** round(-math.log2(peak))
    if photons is None or brightest == 0:
        return factor
    fluxes = photon_fluxes(scene, lights, photons, exposure, units)
    main = max(fluxes)
    # Turn the main flux into a power of two near where it is, and keep the largest below the limit.
    target = 2.0 ** round(math.log2(main * factor))
    while max(fluxes) * target / main > FLUX_LIMIT:
        target /= 2
    return target / (main * main_path_share(scene, exposure)) * main_path_power(scene, exposure) * ABOVE_THE_STEP


def photon_fluxes(
    scene: Scene, lights: Sequence[Source], photons: PhotonPass, exposure: Exposure, units: Normalisation
) -> list[float]:
    """Flux of a photon of the first half as it leaves, per light and target, in its brightest channel."""
    balls = target_balls(scene, units, Refusals())
    spacing = photons.spacing["a"]
    found = []
    for source in lights:
        strength = max(exposure.share(source.strength))
        for centre, radius in balls:
            # A lamp inside the target's ball is treated as one at the ball's radius [P 2.1].
            distance = 1.0 if source.direction is not None else max(length(subtract(centre, source.position)), radius)
            found.append(strength * (spacing / distance) ** 2)
    return found or [0.0]


def main_path_share(scene: Scene, exposure: Exposure) -> float:
    """What the shortest path through the glass leaves of a photon: t^2, or r for a mirror; 1 where it varies."""
    shares = {_path_share(material, exposure) for material in scene.materials.values() if material.is_specular}
    return shares.pop() if len(shares) == 1 else 1.0


def main_path_power(scene: Scene, exposure: Exposure) -> float:
    """The power of two next to the main path's share, which the factor keeps so that images stay near 1."""
    return 2.0 ** round(math.log2(main_path_share(scene, exposure)))


def _path_share(material: Material, exposure: Exposure) -> float:
    if material.fresnel or material.absorption_per_m is not None or material.attenuation is not None:
        return 1.0
    if material.is_transmissive:
        return max(exposure.share(material.transmission)) ** 2 or 1.0
    return max(exposure.share(material.reflection)) or 1.0


def _peak(material: Material) -> tuple[float, float, float]:
    """The brightest emission of a material, checker or not."""
    from vitrail.scene.model import Checker

    emission = material.emission
    assert emission is not None
    if isinstance(emission, Checker):
        first, second = emission.checker.colors
        return (max(first[0], second[0]), max(first[1], second[1]), max(first[2], second[2]))
    return emission


def _at_one_unit(lights: Sequence[Source]) -> float:
    """Lamps count at ten units' distance, suns as they are."""
    return 1.0 if any(source.direction is not None for source in lights) else 0.01
