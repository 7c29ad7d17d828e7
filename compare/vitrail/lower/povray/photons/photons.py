"""The photon pass: spacing, kernel, and a light factor that keeps every photon exact.

POV-Ray stores a photon's flux in 8 bits a channel, truncated, and loses it silently at 32 [P 2.4]. A light factor gives
the flux of the main path the mantissa 255 / 256, and nothing of it is truncated. The second half image needs another
pattern of photons: its spacing is smaller by sqrt(180 / 255), so that the flux has the mantissa 180 / 256, which is
exact too. Where Fresnel or absorption take more from some photons than from others, the truncation starts from there.

The kernel is the flat disc of fixed radius that the tracer uses: ``radius R`` with ``gather 0, many``, which neither
shrinks to the nearest photons nor grows where there are few [P 2.3]. Photons are shot in one execution, which saves
them, and used in a second one, because the engine must order POV-Ray's search tree in between.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from vitrail.base.vector import Vec, length, subtract
from vitrail.geometry.world import World
from vitrail.lower.povray.asked import Asked
from vitrail.lower.povray.bodies.immersion import index_around
from vitrail.lower.povray.bodies.meshes import room_of
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.refusals.refusal import NotTranslatable
from vitrail.lower.povray.text.lights import Source
from vitrail.lower.povray.text.sdl import Block, Quoted, block, listed, statement
from vitrail.scene.model import Material

FLUX_LIMIT = 16.0
"""Largest flux of one photon; POV-Ray loses photons at 32 without a word [P 2.4]."""
SECOND_FLUX = 180 / 255
"""Flux of the second half's photons over the first's; its root, 0.840, is far from any ratio of small numbers."""
JITTER = 1
"""Each photon anywhere in its cell. Spread of an eighth of a patch over eight spacings, jitter 0, 0.4, 0.7 and 1, per
cent: ball lens 0.34, 0.34, 0.37, 0.46; `figure_8` 0.49, 0.50, 0.59, 0.68; `figure_2` 2.6, 1.8, 0.98, 0.54, where the
rings of a lattice and the lens make a pattern. The whole flux of `figure_2` spreads by 0.15, 0.14, 0.05 and 0.05."""
MOST_WASTED = 64
"""Shots for each photon that an aperture or a cone lets through, before the spacing gives in."""
PHOTON_FILE = "photons.map"
"""The saved map, in the folder of the run; the only file name in a scene text, and ours."""
MOST_GATHERED = 1 << 20
"""Photons in one disc before POV-Ray would shrink it; far more than any disc of the supported budgets holds."""


@dataclass(frozen=True)
class Ball:
    """Where POV-Ray aims photons: the ball around the box around a specular object, units."""

    centre: Vec
    radius: float


@dataclass(frozen=True)
class PhotonPass:
    """Spacing of the two halves, radius of the kernel and the targets, units."""

    spacing: dict[str, float]
    gather_radius: float
    targets: tuple[Ball, ...]

    def sdl(self, half: str, file: str = "") -> Block:
        """The photons block of one half; ``file``: ``save_file`` or ``load_file``, or neither."""
        return block(
            "photons",
            statement("spacing", self.spacing[half]),
            statement("radius", self.gather_radius),
            statement("gather", listed(0, MOST_GATHERED)),
            statement("expand_thresholds", listed(0, 0)),
            statement("jitter", JITTER),
            statement("autostop", 1),
            statement(file, Quoted(PHOTON_FILE)) if file else None,
        )


@dataclass(frozen=True)
class Shooting:
    """The lights of one half image and the photons that they shoot at the specular objects of a scene."""

    world: World
    lights: Sequence[Source]
    photons: PhotonPass

    @property
    def specular(self) -> list[Material]:
        """The material of each target."""
        return [material for material in _materials(self.world) if material.is_specular]


def photon_pass(
    asked: Asked, lights: Sequence[Source], balls: tuple[Ball, ...], units: Normalisation, bands: int
) -> PhotonPass | None:
    """The photon pass of a scene, or None when the plan has no caustic. All bands of light share the photons."""
    if not asked.has_caustic:
        return None
    settings = asked.settings
    if settings.photons == 0:
        what = "the scene has a caustic, and without photons POV-Ray lets light straight through glass"
        remedy = "ask for some photons, for example `photons=100000`"
        raise NotTranslatable([asked.refusals.at(what, remedy, "lights")])
    # Share the photons of the settings between the two halves and all bands; count those that may leave their light.
    runs = (1 + 1 / SECOND_FLUX) * bands
    useful = sum(_useful_area(source, ball) for source in lights for ball in balls)
    shot = sum(_shot_area(source, ball) for source in lights for ball in balls)
    area = max(useful, shot / MOST_WASTED)
    spacing = 2.0 ** round(math.log2(math.sqrt(area * runs / settings.photons)))
    return PhotonPass(
        spacing={"a": spacing, "b": spacing * math.sqrt(SECOND_FLUX)},
        gather_radius=units.length(settings.gather_radius_m),
        targets=balls,
    )


def photon_targets(asked: Asked, units: Normalisation) -> tuple[Ball, ...]:
    """A ball for each specular object, none without a caustic; an infinite one is refused."""
    if not asked.has_caustic:
        return ()
    world, balls, refused = asked.world, [], []
    for index, (item, solid) in enumerate(zip(world.scene.objects, world.solids, strict=True)):
        if not world.material(index).is_specular:
            continue
        bounds = room_of(solid)
        if not bounds.is_finite:
            what = f"POV-Ray cannot aim photons at an infinite {item.shape.key}"
            refused.append(
                asked.refusals.at(what, "use a rectangle, a disc or a box", "objects", index, item.shape.key)
            )
            continue
        balls.append(Ball(units.point(bounds.centre), units.length(bounds.radius_m)))
    if refused:
        raise NotTranslatable(refused)
    return tuple(balls)


def _shot_area(source: Source, ball: Ball) -> float:
    """Area at the target over which POV-Ray spreads its shots, units squared: all of the ball, whatever the light."""
    if source.direction is not None:
        return math.pi * ball.radius**2
    distance = length(subtract(ball.centre, source.position))
    return _cap(_half_angle(source, ball)) * distance**2


def _useful_area(source: Source, ball: Ball) -> float:
    """The part of it that an aperture or a cone lets through."""
    if source.direction is not None:
        return min(math.pi * ball.radius**2, source.aperture_area)
    if source.cone is None:
        return _shot_area(source, ball)
    distance = length(subtract(ball.centre, source.position))
    return min(_shot_area(source, ball), _cap(math.radians(source.cone.half_angle_deg)) * distance**2)


def _half_angle(source: Source, ball: Ball) -> float:
    """Half the angle that a ball fills, seen from a lamp; everything from inside."""
    distance = length(subtract(ball.centre, source.position))
    return math.pi if distance <= ball.radius else math.asin(ball.radius / distance)


def _cap(half_angle: float) -> float:
    """Solid angle of a cone."""
    return 2 * math.pi * (1 - math.cos(half_angle))


def photon_flux(source: Source, ball: Ball, spacing: float, strength: float) -> float:
    """Flux of one photon as it leaves a light of ``strength`` (E / pi or I / pi), in POV-Ray's colour times units^2."""
    if source.direction is not None:
        return strength * spacing**2
    # From inside the ball too, photons are ``spacing`` apart at the distance of its middle [P 2.1].
    return strength * (spacing / length(subtract(ball.centre, source.position))) ** 2


def has_exact_flux(shooting: Shooting) -> bool:
    """Whether every photon of a run has the flux of the main path, or none at all."""
    world, lights, materials = shooting.world, shooting.lights, shooting.specular
    if len(lights) > 1 or any(_varies(material) for material in materials):
        return False
    lossless = all(_is_lossless(material) for material in materials)
    if len(shooting.photons.targets) > 1:
        return lossless and lights[0].direction is not None
    if not lossless and _stores_inside(world):
        return False
    return lossless or not (materials[0].is_transmissive and max(materials[0].reflection) > 0)


def _stores_inside(world: World) -> bool:
    """Whether photons may be stored after one face of glass instead of two."""
    scattering = [index for index, material in enumerate(_materials(world)) if material.is_diffuse]
    return any(world.material(index).is_specular or index_around(world, index) != 1 for index in scattering)


def _materials(world: World) -> list[Material]:
    """That of each object."""
    return [world.scene.material_of(item) for item in world.scene.objects]


def _is_lossless(material: Material) -> bool:
    """Whether a photon leaves every face with all its light, in one direction."""
    return min(material.transmission) == 1 or min(material.reflection) == 1


def _varies(material: Material) -> bool:
    """Whether what a face or the inside leaves of light depends on the way it takes."""
    return material.fresnel or material.attenuation is not None or material.absorption_per_m is not None
