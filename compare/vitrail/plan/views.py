"""Views: every observed patch gets a picture of its own, because its numbers want pixels where the question is asked.

A view looks from the scene's eye (an orthographic one from its direction) at the middle of the patch, and is as wide as
the patch and a margin. How fine it is follows from what is measured there, and not from ``image``, which is for people.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from vitrail.base.changed import changed
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.vector import Vec, add, cross, dot, length, scale, subtract, unit
from vitrail.geometry.camera import View
from vitrail.geometry.patch import corners_of
from vitrail.geometry.world import World
from vitrail.plan.plan import Plan
from vitrail.plan.sampling import samples_to_see
from vitrail.plan.settings import Quality, Settings
from vitrail.scene.model import Camera, Image, Observation, Patch

FINE, MIDDLE, COARSE = 128, 96, 64
PIXELS: dict[Phenomenon, int] = {
    Phenomenon.CAUSTIC: FINE,
    Phenomenon.DISPERSION: FINE,
    Phenomenon.SHADOW: FINE,
    Phenomenon.ROUGHNESS: FINE,
    Phenomenon.REFRACTION: MIDDLE,
    Phenomenon.REFLECTION: MIDDLE,
    Phenomenon.TOTAL_INTERNAL_REFLECTION: MIDDLE,
    Phenomenon.COLOURED_TRANSMISSION: COARSE,
    Phenomenon.ABSORPTION: COARSE,
    Phenomenon.DIFFUSION: COARSE,
    Phenomenon.INDIRECT_LIGHT: COARSE,
}
"""Pixels along the longer side of a patch: fine for rings and edges, fewer for a moved pattern, fewest for means."""

EDGES, MEANS, ROUGH, BARE = 48, 16, 64, 64
SAMPLES: dict[Phenomenon, int] = {
    Phenomenon.REFRACTION: EDGES,
    Phenomenon.REFLECTION: EDGES,
    Phenomenon.TOTAL_INTERNAL_REFLECTION: EDGES,
    Phenomenon.SHADOW: EDGES,
    Phenomenon.ROUGHNESS: ROUGH,
}
"""Samples of a pixel at least where the place of an edge is asked, and ``MEANS`` elsewhere.

An edge along the rows of a view lies at one place of every pixel, which POV-Ray's grids know to a tenth of a pixel with
48 samples, half of the tolerance, and to a third with 4. A view has so few pixels that starting POV-Ray costs more, but
where each sample gathers photons: what was seen through figure 1's ball took 136 of its 165 CPU s, and figure 5 took
253 for ``ROUGH``. A card that no glass covers has ``BARE`` there: stray photons are finer than its pixels, four times
the samples leave a third of their noise, and take .5 CPU s. What ``image`` says of samples is for people, as its size.
The blur of a frosted pane was known to 160 % with 4, to 81 % with 16, and to its tolerance of 11 % with ``ROUGH``."""

THIN = 32
"""Pixels along the shorter side at least, for a patch that is narrow or seen at a slant."""

WIDEST = 4
"""A view is at most so many times as fine as its metric needs, however thin the patch is seen."""

MARGIN = 1 / 16
"""Pixels around the patch over those along it: a slope reads a neighbour, and eyes want to see where the patch ends."""

LEAST_MARGIN = 3
"""Pixels of margin at least."""

STEEPEST = math.tan(math.radians(60))
"""A view is at most 120 degrees wide; beyond that its outer pixels are stretched and the scene's own camera stays."""

PARALLEL = 0.02
"""An up vector within this sine (1.1 degrees) of the line of sight says nothing about what is up."""


PICTURE_WIDTH = 480
"""Pixels across the scene's own picture at least, where it is for people."""

LARGEST = 1024
"""Pixels along one side at most, of a picture that is made finer than its scene says."""

TOKEN = 8
"""Pixels along the shorter side of a picture that nobody looks at."""

PICTURE_SAMPLES = 1
"""Samples of a pixel in a picture for people: it has so many pixels that eyes average over them."""


@dataclass(frozen=True)
class ObservationView:
    """One picture for the observations of one patch. ``name`` is that of the first, as a file can be named."""

    name: str
    observations: tuple[str, ...]
    camera: Camera
    image: Image
    samples: int


def views_of(
    world: World, plan: Plan, settings: Settings, *, fixed_samples: bool = False
) -> tuple[ObservationView, ...]:
    """A view for each observed patch, in the order of the scene. Observations of one patch share its view.

    With ``fixed_samples`` every view has the samples of ``settings``, as where somebody asked for them.
    """
    patches: dict[Patch, list[Observation]] = {}
    for entry in world.scene.observe:
        patches.setdefault(entry.patch, []).append(entry)
    names = _file_names([entries[0].name for entries in patches.values()])
    return tuple(
        _view(world, plan, settings, name, entries, fixed_samples)
        for name, entries in zip(names, patches.values(), strict=True)
    )


def for_people(image: Image, width: int = PICTURE_WIDTH) -> Image:
    """The scene's own picture, at least ``width`` pixels wide; each pixel of the scene becomes a square of pixels."""
    times = max(min(math.ceil(width / image.width), LARGEST // max(image.width, image.height)), 1)
    return changed(image, width=image.width * times, height=image.height * times)


def token(image: Image) -> Image:
    """The smallest picture of this shape that engines draw with ease, where nobody looks at it."""
    shorter = min(image.width, image.height) / TOKEN
    return changed(image, width=max(round(image.width / shorter), 1), height=max(round(image.height / shorter), 1))


def _view(
    world: World, plan: Plan, settings: Settings, name: str, entries: Sequence[Observation], fixed_samples: bool
) -> ObservationView:
    patch, scene = entries[0].patch, world.scene
    pixels = max(PIXELS[entry.phenomenon] for entry in entries)
    framed = _framed(scene.camera, scene.image, patch, pixels)
    camera, image = framed or _unmoved(scene.camera, scene.image, patch, pixels)
    samples = settings.samples
    if not fixed_samples and settings.quality is not Quality.DRAFT:
        samples = max(samples, *(_samples(entry.phenomenon, plan) for entry in entries))
        observes_caustic = any(entry.phenomenon is Phenomenon.CAUSTIC for entry in entries)
        if framed and observes_caustic and plan.requires(Phenomenon.CAUSTIC):
            samples = max(samples, samples_to_see(View.of(camera, image), patch, settings.gather_radius_m))
    return ObservationView(name, tuple(entry.name for entry in entries), camera, image, samples)


def _samples(phenomenon: Phenomenon, plan: Plan) -> int:
    """Samples of a pixel at least; where photons are gathered for each of them, little is seen through glass."""
    if plan.requires(Phenomenon.CAUSTIC):
        return BARE if phenomenon is Phenomenon.DIFFUSION else MEANS
    return SAMPLES.get(phenomenon, MEANS)


def _framed(camera: Camera, image: Image, patch: Patch, pixels: int) -> tuple[Camera, Image] | None:
    """The camera that looks at the patch and the size of its picture; None where the eye cannot frame it."""
    aimed = _aimed(camera, image, patch)
    if aimed is None:
        return None
    seen = [View.of(aimed, image).to_view(corner) for corner in corners_of(patch)]
    if min(depth for _, _, depth in seen) <= 0:
        return None
    far = [depth if camera.kind == "perspective" else 1.0 for _, _, depth in seen]
    half_x = max(abs(x) / away for (x, _, _), away in zip(seen, far, strict=True))
    half_y = max(abs(y) / away for (_, y, _), away in zip(seen, far, strict=True))
    pixel = _pixel(half_x, half_y, pixels)
    width, height = (_pixels_across(2 * half / pixel) for half in (half_x, half_y))
    half_width, half_height = width * pixel / 2, height * pixel / 2
    size = changed(image, width=width, height=height)
    if camera.kind == "orthographic":
        return changed(aimed, height=2 * half_height), size
    if max(half_width, half_height) > STEEPEST:
        return None
    return changed(aimed, fov_deg=2 * math.degrees(math.atan(half_height))), size


def _aimed(camera: Camera, image: Image, patch: Patch) -> Camera | None:
    """The camera with the middle of the patch in the middle of its picture; None from within the patch."""
    own = View.of(camera, image)
    if camera.kind == "orthographic":
        right, up, _ = own.to_view(patch.center)
        aside = add(scale(own.right, right), scale(own.up, up))
        return changed(camera, position=add(camera.position, aside), look_at=add(camera.look_at, aside))
    sight = subtract(patch.center, camera.position)
    if length(sight) == 0:
        return None
    return changed(camera, look_at=patch.center, up=_up(camera.up, own, unit(sight)))


def _up(up: Vec, own: View, forward: Vec) -> Vec:
    """The scene's up; else what is up in its picture, else what is ahead there."""
    choices = (unit(up), own.up, own.forward)
    # The last two are at right angles, so that no line of sight is along both.
    return next(each for each in choices if length(cross(each, forward)) > PARALLEL)


def _pixel(half_x: float, half_y: float, pixels: int) -> float:
    """The edge of a pixel, in the unit of the half sizes: fine enough for the longer side, and for the shorter one."""
    longer, shorter = 2 * max(half_x, half_y), 2 * min(half_x, half_y)
    return max(min(longer / pixels, shorter / THIN), longer / (WIDEST * pixels))


def _pixels_across(patch: float) -> int:
    """Pixels of a view along one side: the patch, and as many to its left as to its right."""
    # A whole number but for rounding is whole, so that the edges of the patch lie on edges of pixels.
    inner = max(math.ceil(patch - 1e-6), 1)
    return inner + 2 * max(LEAST_MARGIN, math.ceil(inner * MARGIN))


def _unmoved(camera: Camera, image: Image, patch: Patch, pixels: int) -> tuple[Camera, Image]:
    """The scene's own camera, with a picture as many times as fine as the patch needs."""
    view = View.of(camera, image)
    edges = [2 * length(edge) * abs(_facing(view, patch, edge)) for edge in (patch.u, patch.v)]
    size = view.pixel_size_m(patch.center)
    across = max(edges) / size if size > 0 else pixels
    finer = min(max(math.ceil(pixels / max(across, 1e-9)), 1), max(LARGEST // max(image.width, image.height), 1))
    return camera, changed(image, width=image.width * finer, height=image.height * finer)


def _facing(view: View, patch: Patch, edge: Vec) -> float:
    """How much of an edge of a patch is seen from the camera: the sine of its angle to the line of sight."""
    if length(view.direction_to(patch.center)) == 0:
        return 1.0
    return math.sqrt(max(1 - dot(unit(edge), view.sight_line(patch.center)) ** 2, 0.0))


def _file_names(names: Sequence[str]) -> list[str]:
    """Names of observations as names of files, each once."""
    plain = [re.sub(r"[^A-Za-z0-9_-]", "_", name) for name in names]
    return [name if name not in plain[:place] else f"{name}-{place}" for place, name in enumerate(plain)]
