"""One object of the scene as POV-Ray text: shape, texture, inside, and what photons do with it."""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.lower.povray.exposure import Exposure, Triplet
from vitrail.lower.povray.indices import Indices
from vitrail.lower.povray.materials import texture_sdl
from vitrail.lower.povray.meshes import Meshes, mesh_parts
from vitrail.lower.povray.nesting import Cut
from vitrail.lower.povray.normalise import Normalisation
from vitrail.lower.povray.roughness import Bumps, bumps_of
from vitrail.lower.povray.sdl import block, rgb
from vitrail.lower.povray.shapes import Primitive, primitive
from vitrail.lower.povray.surface import Surface
from vitrail.optics.dispersion import reference_ior
from vitrail.plan.plan import Plan
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.model import Ambient, Material, Object, Scene
from vitrail.scene.phenomenon import Phenomenon
from vitrail.scene.placement import Placed


@dataclass(frozen=True)
class ObjectText:
    """What turns the objects of one scene into text; ``has_photons`` makes specular ones the targets of photons."""

    scene: Scene
    plan: Plan
    units: Normalisation
    has_photons: bool
    indices: Indices
    meshes: Meshes
    has_media: bool = False

    def sdl(
        self,
        item: Object,
        placed: Placed,
        exposure: Exposure,
        is_shooting: bool,
        cuts: tuple[Cut, ...] = (),
        shares_room: bool = False,
    ) -> str:
        """The object in one run; ``placed`` is its shape, where a gap has been opened already."""
        material = self.scene.material_of(item)
        shape = self._shape(item, placed)
        after = [
            *self._textures(material, placed, exposure),
            self._interior(material, exposure, is_shooting, shares_room),
            self._photons(material),
        ]
        if not cuts:
            return block(shape.keyword, [*shape.parts, *after])
        # The faces that a cut leaves belong to the solid that cuts.
        parts = [block(shape.keyword, shape.parts)]
        for cut in cuts:
            cutter = self.scene.material_of(self.scene.objects[cut.by])
            look = cutter if material.is_transmissive else material
            inner = primitive(cut.placed, self.units)
            parts.append(block(inner.keyword, [*inner.parts, self._texture(look, cut.placed, exposure)]))
        return block("difference", [*parts, *after])

    def _shape(self, item: Object, placed: Placed) -> Primitive:
        if item.name in self.meshes:
            return Primitive("mesh2", tuple(mesh_parts(self.meshes[item.name], self.units)))
        return primitive(placed, self.units)

    def _texture(self, material: Material, placed: Placed, exposure: Exposure, bumps: Bumps | None = None) -> str:
        return texture_sdl(Surface(material, placed, exposure, self.units, self._has_ambient, bumps))

    def _textures(self, material: Material, placed: Placed, exposure: Exposure) -> list[str]:
        """The look of an object; rough glass looks different from inside."""
        if material.roughness == 0 or not material.is_specular:
            return [self._texture(material, placed, exposure)]
        index = reference_ior(material)
        outer = self._texture(material, placed, exposure, bumps_of(material, index, from_inside=False))
        if not material.is_transmissive:
            return [outer]
        inner = self._texture(material, placed, exposure, bumps_of(material, index, from_inside=True))
        return [outer, f"interior_{inner}"]

    @property
    def _has_ambient(self) -> bool:
        return isinstance(self.scene.transport.indirect, Ambient) and self.plan.requires(Phenomenon.INDIRECT_LIGHT)

    def _interior(self, material: Material, exposure: Exposure, is_shooting: bool, shares_room: bool) -> str:
        """The index where light enters or Fresnel asks for it, and the absorption where the plan wants it.

        ``interior`` absorbs only up to a face of its own solid; with others inside, a medium does, all along the ray.
        """
        if not material.is_transmissive and not (material.fresnel and material.is_specular):
            return ""
        absorbing = material.is_transmissive and self.plan.requires(Phenomenon.ABSORPTION)
        inside = ""
        if absorbing and max(absorption_per_m(material)) > 0:
            per_unit = exposure.share(self._absorption_per_unit(material))
            inside = f"media {{ absorption {rgb(per_unit)} }}" if shares_room else _fade(per_unit)
        interior = block("interior", [self.indices.sdl(material, exposure, is_shooting), inside])
        return f"{interior}\nhollow" if self.has_media and material.is_transmissive else interior

    def _absorption_per_unit(self, material: Material) -> Triplet:
        red, green, blue = absorption_per_m(material)
        return (red / self.units.scale, green / self.units.scale, blue / self.units.scale)

    def _photons(self, material: Material) -> str:
        """Photons are aimed at everything specular; only what scatters collects them."""
        if not self.has_photons or not material.is_specular:
            return ""
        refraction = "on" if material.is_transmissive else "off"
        reflection = "on" if max(material.reflection) > 0 or material.fresnel else "off"
        collect = "" if material.is_diffuse else "collect off"
        return block("photons", ["target", f"refraction {refraction}", f"reflection {reflection}", collect])


def _fade(per_unit: Triplet) -> str:
    """exp(-(1 - fade_color) x / fade_distance), which is Beer-Lambert with fade_color = 1 - sigma [P 3.3]."""
    if max(per_unit) == 0:
        return ""
    remaining = (1 - per_unit[0], 1 - per_unit[1], 1 - per_unit[2])
    return f"fade_distance 1 fade_power 1001 fade_color {rgb(remaining)}"
