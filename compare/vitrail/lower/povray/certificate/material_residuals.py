"""What POV-Ray does differently with a material, as entries of the certificate."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from vitrail.base.colour import Triplet
from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray.certificate.certificate import RELATIVE, Entry, Named, the_material
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.indices import Indices
from vitrail.lower.povray.text.modes import Mode
from vitrail.lower.povray.text.surface import is_grey, specular_pool
from vitrail.optics.bands import Band, band_model, povray_hues
from vitrail.optics.dispersion import ior_by_band, reference_ior
from vitrail.scene.model import Ggx, Material, Paper, Scene

EQUATION_8_WIDTH = 0.06
"""Largest deviation of the blur behind a pane from equation 8, measured for lambda up to 0.3 against a random walk.

Up to 5.4 % for lambda 0.1 (interval included), where pixels are coarse beside the blur, and 1.6 % for 0.3.
"""
EQUATION_8_LOSS = 0.1
"""What each unit of lambda beyond 0.3 adds: steep bumps reflect totally, 2.9 % of the light behind a pane at 0.5.

The blur itself deviates by 6.7 % there, at most 7.7 % by its interval.
"""
GGX_WIDTH, GGX_SLOPE = 0.03, 0.4
"""The same for GGX, whose tails bumps cut off, and by how much it grows with alpha.

Measured: 0.2 % of the blur at alpha 0.05 (2.8 % by its interval), 6.2 % at 0.2 (7.9 %), with 4.7 % of the light lost.
"""


def material_entries(scene: Scene, mode: Mode, indices: Indices) -> Iterator[Entry]:
    """Shares, dispersion and roughness, material by material."""
    for name, material in scene.materials.items():
        if not material.is_specular:
            continue
        if mode.shows_all_channels:
            yield from _pool(the_material(name), material)
        if len(mode.bands) > 1:
            yield from _dispersion(the_material(name), material, mode, indices)
        yield from _roughness(the_material(name), material)


def mirror_share(material: Material) -> float:
    """What one reflection leaves at most of a path that also goes on by other ways: r, or R at normal incidence."""
    if not material.fresnel:
        return max(material.reflection)
    index = reference_ior(material)
    return ((index - 1) / (index + 1)) ** 2


def longest_lived_share(material: Material) -> float:
    """What one reflection leaves of a path at most where light could also go through: r, by Fresnel nearly all."""
    near_total = material.fresnel and material.is_transmissive and material.ior != 1
    return max(specular_pool(material, Exposure())) if near_total else mirror_share(material)


def trapped_share(material: Material) -> float:
    """What one crossing, or one total reflection instead, leaves of a path at most."""
    if not material.is_transmissive:
        return 0.0
    bends = material.fresnel or material.ior != 1
    return max(specular_pool(material, Exposure()) if bends else material.transmission)


def _pool(item: Named, material: Material) -> Iterator[Entry]:
    """Glass whose channels differ, in a run that shows all of them: total reflection and Fresnel miss s."""
    pool = specular_pool(material, Exposure())
    if not material.is_transmissive or is_grey(pool):
        return
    yield from _coloured_pool(item, material, pool)


def _coloured_pool(item: Named, material: Material, pool: Triplet) -> Iterator[Entry]:
    least = min(pool)
    yield Entry(
        Phenomenon.TOTAL_INTERNAL_REFLECTION,
        item,
        "total reflection keeps r + t",
        "total reflection keeps 1",
        1 - least,
        RELATIVE,
        "POV-Ray does not colour total reflection; render one channel at a time to have it exact",
    )
    if material.fresnel:
        normal = mirror_share(material)
        yield Entry(
            Phenomenon.COLOURED_TRANSMISSION,
            item,
            "s (1 - R)",
            "s (1 - s R)",
            normal * (1 - least) / (1 - normal),
            RELATIVE,
            "conserve_energy takes the mirrored colour, s R, for R; given at normal incidence, two faces count twice",
        )


def _dispersion(item: Named, material: Material, mode: Mode, indices: Indices) -> Iterator[Entry]:
    """Slices have no error where each band has one; the native law has that of its fit, and its own colours."""
    if not material.is_dispersive or not material.is_transmissive:
        return
    law, all_bands = indices.native_law(material), band_model(indices.scene.transport.bands).bands
    yield Entry(
        Phenomenon.DISPERSION,
        item,
        f"n in {len(all_bands)} bands",
        f"one run for each of {len(mode.bands)} bands" if law is None else "n = ior D^((555 - nm) / 350)",
        _widened(material, all_bands, mode.bands, indices.scene.paper) if law is None else law.largest_residual,
        "index",
        mode.reason if law is None else "POV-Ray's law has two numbers; least squares over the bands",
    )
    if law is not None:
        yield Entry(
            Phenomenon.DISPERSION,
            item,
            f"{len(mode.bands)} bands that add up to white",
            "as many in POV-Ray's hues",
            _other_hues(mode.bands),
            RELATIVE,
            "what bands of other colours take of a channel or leave; POV-Ray's own white is (.9938, 1, .9962)",
        )


def _widened(material: Material, bands: Sequence[Band], wide: Sequence[Band], paper: Paper) -> float:
    """How far the index of a band is at most from that of the wider band which stands for it."""
    if len(bands) == len(wide):
        return 0.0
    own, standing = ior_by_band(material, bands, paper), ior_by_band(material, wide, paper)
    # Both models divide one range of wavelengths evenly.
    return max(abs(index - standing[k * len(wide) // len(bands)]) for k, index in enumerate(own))


def _other_hues(bands: Sequence[Band]) -> float:
    """The share of a channel, the worst of three, that POV-Ray's hues put into other bands or lose."""
    hues = povray_hues(max(2, len(bands)))
    return max(
        sum(abs(band.weight[channel] - hue.weight[channel]) for band, hue in zip(bands, hues, strict=True))
        for channel in range(3)
    )


def _roughness(item: Named, material: Material) -> Iterator[Entry]:
    """Lobes of equal width, made of turned normals."""
    roughness = material.roughness
    if roughness == 0:
        return
    if isinstance(roughness, Ggx):
        law, residual = f"GGX, alpha {roughness.ggx:g}", max(GGX_WIDTH, GGX_SLOPE * roughness.ggx)
    else:
        law = f"equation 8, lambda {roughness:g}"
        residual = EQUATION_8_WIDTH + EQUATION_8_LOSS * max(0.0, roughness - 0.3)
    yield Entry(
        Phenomenon.ROUGHNESS,
        item,
        law,
        "a mixture of bumps, far smaller than a pixel",
        residual,
        RELATIVE,
        "width of the blur; POV-Ray turns normals, so a mirror's lobe and grazing light differ more",
    )
