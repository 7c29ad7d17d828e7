"""The paper's material as POV-Ray textures: d, r and t independent of each other, exact for camera rays and photons.

One layer cannot do it, because POV-Ray takes d and t from one pigment [P 4.2]. With s = r + t the same in every
channel, a face is the *average* of two textures by weight: with weight s a clear one that only mirrors and refracts,
and with weight 1 - s an opaque one that only scatters. POV-Ray lets total internal reflection through at full strength
whatever the finish says [P 4.1]; inside the average it then carries the weight s, which is the scene's law.
The Fresnel split is exact for the same reason. Glow is a third texture, because a pigment has one colour; where s is 1
it takes a weight of 1 / 16384. Where s differs by channel (native runs only), two layers stand in, or beside a glow the
largest s.
"""

from __future__ import annotations

from vitrail.base.colour import Triplet
from vitrail.lower.povray.text.patterns import coloured
from vitrail.lower.povray.text.sdl import Block, Colour, MapEntry, Part, block, listed, rgb, statement
from vitrail.lower.povray.text.surface import GREY_SLACK, Surface, is_grey
from vitrail.scene.model import Material

LAYER_SHARE = 0.5
"""How much the lower, scattering layer lets through; the filter layer above makes up for it [P 4.2]."""
GLOW_WEIGHT = 2.0**-14
"""The least weight of what is not clear in glass that glows: a tenth of a half float's step is taken from the clear."""
DARKEST_FILTER = 1e-4
"""Filter of a channel without transmission but with diffuse share: the layer below must stay visible [P 4.2]."""


Layers = tuple[Block, ...]
"""The textures of one face, the lowest first; nearly always one."""
Weighted = tuple[float, Block]
"""A texture and its share of an average."""


def textures_sdl(surface: Surface) -> Layers:
    """The textures of an object, ready to stand after its shape."""
    material = surface.material
    if not material.is_transmissive:
        return (_average(_opaque_parts(surface)),)
    if max(surface.pool) == 0:
        return (_average([*_scattering(surface, 1.0, 1.0), *_glow(surface, 1.0)] or [(1.0, _black())]),)
    if is_grey(surface.pool) or material.emission is not None:
        return (_averaged_glass(surface),)
    return _layered_glass(surface)


def as_interior(layers: Layers) -> Layers:
    """The same textures as the look of a face from inside."""
    return tuple(Block("interior_texture", layer.parts) for layer in layers)


# --- opaque ---------------------------------------------------------------------------------------------------------


def _opaque_parts(surface: Surface) -> list[Weighted]:
    """Scattering with the mirror in one texture; glow as a second one, because it has its own colour."""
    material = surface.material
    mirror = _mirror(material, surface.exposure.share(material.reflection), keep_energy=False)
    if material.emission is None:
        pigment = coloured(material.diffuse, surface, 1.0, light=False)
        return [(1.0, block("texture", pigment, _normal(surface), _finish(*surface.scatters, *mirror)))]
    if not material.is_diffuse and not mirror:
        return list(_glow(surface, 1.0))
    # Split evenly, doubled to make up for it.
    doubled = _mirror(material, _times(surface.exposure.share(material.reflection), 2.0), keep_energy=False)
    pigment = coloured(material.diffuse, surface, 2.0, light=False)
    scatter = block("texture", pigment, _finish(*surface.scatters, *doubled))
    return [(0.5, scatter), *((0.5, texture) for _, texture in _glow(surface, 2.0))]


def _scattering(surface: Surface, weight: float, factor: float) -> list[Weighted]:
    if not surface.material.is_diffuse:
        return []
    pigment = coloured(surface.material.diffuse, surface, factor, light=False)
    return [(weight, block("texture", pigment, _finish(*surface.scatters)))]


def _glow(surface: Surface, factor: float) -> list[Weighted]:
    if surface.material.emission is None:
        return []
    pigment = coloured(surface.material.emission, surface, factor, light=True)
    return [(1.0, block("texture", pigment, _finish(statement("emission", 1))))]


# --- glass ----------------------------------------------------------------------------------------------------------


def _averaged_glass(surface: Surface) -> Block:
    """Clear with weight s, opaque with weight 1 - s, which scattering and glow share evenly."""
    glows = surface.material.emission is not None
    share = min(max(surface.pool), 1 - GLOW_WEIGHT) if glows else max(surface.pool)
    clear = _clear(surface, share)
    if share >= 1 - GREY_SLACK:
        return clear
    weight = (1 - share) / (2 if glows and surface.material.is_diffuse else 1)
    glow = [(weight, texture) for _, texture in _glow(surface, 1 / weight)]
    opaque = [*_scattering(surface, weight, 1 / weight), *glow]
    return _average([(share, clear), *(opaque or [(1 - share, _black())])])


def _clear(surface: Surface, share: float) -> Block:
    """Mirrors and refracts all light: r / s and t / s, or by Fresnel."""
    material, exposure = surface.material, surface.exposure
    if material.fresnel:
        whole = rgb(_times(surface.pool, 1 / share))
        return block("texture", _filter(whole), _normal(surface), _finish(_fresnel(whole), KEEP_ENERGY))
    transmission = _times(exposure.share(material.transmission), 1 / share)
    mirror = _mirror(material, _times(exposure.share(material.reflection), 1 / share), keep_energy=False)
    return block("texture", _filter(rgb(transmission)), _normal(surface), _finish(*mirror))


def _layered_glass(surface: Surface) -> Layers:
    """A filter above a scattering layer; the mirror belongs to the lower one, which its Fresnel dimming then spares."""
    material, exposure = surface.material, surface.exposure
    pool = surface.pool if material.fresnel else exposure.share(material.transmission)
    mirror = _mirror(
        material,
        surface.pool if material.fresnel else exposure.share(material.reflection),
        keep_energy=material.fresnel,
    )
    if not material.is_diffuse:
        return (block("texture", _filter(rgb(pool)), _normal(surface), _finish(*mirror)),)
    # Divide the lower layer by what the filter above takes from it, channel by channel.
    above = tuple(max(value / LAYER_SHARE, DARKEST_FILTER) for value in pool)
    below = tuple(1 / (value * (1 - LAYER_SHARE)) for value in above)
    scatter = coloured(material.diffuse, surface, below, light=False, passing=("transmit", LAYER_SHARE))
    normal, finish = _normal(surface), _finish(*surface.scatters, *mirror)
    return (block("texture", scatter, normal, finish), block("texture", _filter(rgb(above)), normal))


# --- parts of a texture ---------------------------------------------------------------------------------------------

KEEP_ENERGY = statement("conserve_energy")


def _mirror(material: Material, colour: Triplet, *, keep_energy: bool) -> tuple[Part, ...]:
    if max(colour) == 0:
        return ()
    if material.fresnel:
        return (_fresnel(rgb(colour)), KEEP_ENERGY) if keep_energy else (_fresnel(rgb(colour)),)
    return (block("reflection", statement(rgb(colour))),)


def _fresnel(colour: Colour) -> Block:
    return block("reflection", listed(0, colour), statement("fresnel", "on"))


def _filter(colour: Colour) -> Block:
    """A pigment that lets all light through that its colour leaves."""
    return block("pigment", statement(colour, "filter", 1))


def _normal(surface: Surface) -> Block | None:
    """The bumps of a rough face, on its mirroring and refracting texture only."""
    if surface.bumps is None:
        return None
    return surface.bumps.sdl(surface.normalisation.extent, surface.exposure.half)


def _finish(*parts: Part) -> Block | None:
    return block("finish", *parts) if parts else None


def _black() -> Block:
    return block("texture", block("pigment", statement(rgb((0, 0, 0)))))


def _average(parts: list[Weighted]) -> Block:
    """One texture as it is; several as their average by weight."""
    if len(parts) == 1:
        return parts[0][1]
    entries = [MapEntry(weight, texture.parts) for weight, texture in parts]
    return block("texture", statement("average"), block("texture_map", *entries))


def _times(colour: Triplet, factor: float) -> Triplet:
    return (colour[0] * factor, colour[1] * factor, colour[2] * factor)
