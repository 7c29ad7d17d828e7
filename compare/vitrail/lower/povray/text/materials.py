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

from vitrail.lower.povray.text.exposure import Triplet
from vitrail.lower.povray.text.patterns import coloured
from vitrail.lower.povray.text.sdl import block, number, rgb
from vitrail.lower.povray.text.surface import GREY_SLACK, Surface, is_grey
from vitrail.scene.model import Material

LAYER_SHARE = 0.5
"""How much the lower, scattering layer lets through; the filter layer above makes up for it [P 4.2]."""
GLOW_WEIGHT = 2.0**-14
"""The least weight of what is not clear in glass that glows: a tenth of a half float's step is taken from the clear."""
DARKEST_FILTER = 1e-4
"""Filter of a channel without transmission but with diffuse share: the layer below must stay visible [P 4.2]."""


def texture_sdl(surface: Surface) -> str:
    """The texture of an object, ready to stand after its shape."""
    material = surface.material
    if not material.is_transmissive:
        return _weighted(_opaque_parts(surface))
    if max(surface.pool) == 0:
        return _weighted([*_scattering(surface, 1.0, 1.0), *_glow(surface, 1.0)] or [(1.0, _black())])
    if is_grey(surface.pool) or material.emission is not None:
        return _averaged_glass(surface)
    return _layered_glass(surface)


# --- opaque ---------------------------------------------------------------------------------------------------------


def _opaque_parts(surface: Surface) -> list[tuple[float, str]]:
    """Scattering with the mirror in one texture; glow as a second one, because it has its own colour."""
    material = surface.material
    mirror = _mirror(material, surface.exposure.share(material.reflection), keep_energy=False)
    if material.emission is None:
        return [
            (
                1.0,
                _texture(
                    coloured(material.diffuse, surface, 1.0, light=False),
                    _normal(surface),
                    _finish(surface.scatters, mirror),
                ),
            )
        ]
    if not material.is_diffuse and not mirror:
        return list(_glow(surface, 1.0))
    # Split evenly, doubled to make up for it.
    doubled = _mirror(material, _times(surface.exposure.share(material.reflection), 2.0), keep_energy=False)
    scatter = _texture(coloured(material.diffuse, surface, 2.0, light=False), _finish(surface.scatters, doubled))
    return [(0.5, scatter), *((0.5, body) for _, body in _glow(surface, 2.0))]


def _scattering(surface: Surface, weight: float, factor: float) -> list[tuple[float, str]]:
    if not surface.material.is_diffuse:
        return []
    return [
        (weight, _texture(coloured(surface.material.diffuse, surface, factor, light=False), _finish(surface.scatters)))
    ]


def _glow(surface: Surface, factor: float) -> list[tuple[float, str]]:
    if surface.material.emission is None:
        return []
    return [(1.0, _texture(coloured(surface.material.emission, surface, factor, light=True), _finish("emission 1")))]


# --- glass ----------------------------------------------------------------------------------------------------------


def _averaged_glass(surface: Surface) -> str:
    """Clear with weight s, opaque with weight 1 - s, which scattering and glow share evenly."""
    glows = surface.material.emission is not None
    share = min(max(surface.pool), 1 - GLOW_WEIGHT) if glows else max(surface.pool)
    clear = (share, _clear(surface, share))
    if share >= 1 - GREY_SLACK:
        return _weighted([(1.0, clear[1])])
    weight = (1 - share) / (2 if glows and surface.material.is_diffuse else 1)
    glow = [(weight, body) for _, body in _glow(surface, 1 / weight)]
    opaque = [*_scattering(surface, weight, 1 / weight), *glow]
    return _weighted([clear, *(opaque or [(1 - share, _black())])])


def _clear(surface: Surface, share: float) -> str:
    """Mirrors and refracts all light: r / s and t / s, or by Fresnel."""
    material, exposure = surface.material, surface.exposure
    if material.fresnel:
        whole = rgb(_times(surface.pool, 1 / share))
        return _texture(f"{whole} filter 1", _normal(surface), _finish(_fresnel(whole), "conserve_energy"))
    transmission = _times(exposure.share(material.transmission), 1 / share)
    mirror = _mirror(material, _times(exposure.share(material.reflection), 1 / share), keep_energy=False)
    return _texture(f"{rgb(transmission)} filter 1", _normal(surface), _finish(mirror))


def _layered_glass(surface: Surface) -> str:
    """A filter above a scattering layer; the mirror belongs to the lower one, which its Fresnel dimming then spares."""
    material, exposure = surface.material, surface.exposure
    pool = surface.pool if material.fresnel else exposure.share(material.transmission)
    mirror = _mirror(
        material,
        surface.pool if material.fresnel else exposure.share(material.reflection),
        keep_energy=material.fresnel,
    )
    if not material.is_diffuse:
        return _texture(f"{rgb(pool)} filter 1", _normal(surface), _finish(mirror))
    # Divide the lower layer by what the filter above takes from it, channel by channel.
    above = tuple(max(value / LAYER_SHARE, DARKEST_FILTER) for value in pool)
    below = tuple(1 / (value * (1 - LAYER_SHARE)) for value in above)
    scatter = coloured(material.diffuse, surface, below, light=False, suffix=f" transmit {number(LAYER_SHARE)}")
    normal, look = _normal(surface), _finish(surface.scatters, mirror)
    return "\n".join([_texture(scatter, normal, look), _texture(f"{rgb(above)} filter 1", normal)])


# --- text -----------------------------------------------------------------------------------------------------------


def _mirror(material: Material, colour: Triplet, *, keep_energy: bool) -> str:
    if max(colour) == 0:
        return ""
    if material.fresnel:
        return _fresnel(rgb(colour)) + (" conserve_energy" if keep_energy else "")
    return f"reflection {{ {rgb(colour)} }}"


def _fresnel(colour: str) -> str:
    return f"reflection {{ 0, {colour} fresnel on }}"


def _texture(pigment: str, *others: str) -> str:
    return block("texture", [f"pigment {{ {pigment} }}", *others])


def _normal(surface: Surface) -> str:
    """The bumps of a rough face, on its mirroring and refracting texture only."""
    return surface.bumps.sdl(surface.normalisation.extent, surface.exposure.half) if surface.bumps is not None else ""


def _finish(*parts: str) -> str:
    kept = [part for part in parts if part]
    return f"finish {{ {' '.join(kept)} }}" if kept else ""


def _black() -> str:
    return _texture("rgb 0", "")


def _weighted(parts: list[tuple[float, str]]) -> str:
    """One texture as it is; several as their average by weight."""
    if len(parts) == 1:
        return parts[0][1]
    entries = []
    for weight, body in parts:
        inner = body.removeprefix("texture {").removesuffix("}").strip()
        entries.append(f"[{number(weight)} {inner}]")
    return block("texture", ["average", block("texture_map", entries)])


def _times(colour: Triplet, factor: float) -> Triplet:
    return (colour[0] * factor, colour[1] * factor, colour[2] * factor)
