"""One object of the scene as POV-Ray text: shape, texture, inside, and what photons do with it."""

from __future__ import annotations

from dataclasses import dataclass, field

from vitrail.base.colour import Triplet
from vitrail.base.phenomenon import Phenomenon
from vitrail.geometry.solid import Solid
from vitrail.geometry.world import World
from vitrail.lower.povray.bodies.immersion import glass_around, glass_at_camera, partly_around
from vitrail.lower.povray.bodies.nesting import Cut, Nesting
from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.materials import Layers, as_interior, textures_sdl
from vitrail.lower.povray.text.roughness import Bumps, bumps_of
from vitrail.lower.povray.text.sdl import Block, Part, block, rgb, statement
from vitrail.lower.povray.text.shapes import Primitive, primitive
from vitrail.lower.povray.text.surface import Surface, specular_pool
from vitrail.lower.povray.translation import Translation
from vitrail.optics.dispersion import reference_ior
from vitrail.scene.absorption import absorption_per_m
from vitrail.scene.model import Ambient, Material, Scene

CLEAR = block("texture", block("pigment", statement(rgb((1, 1, 1)), "filter", 1)))
"""A face that does nothing at equal index."""


@dataclass(frozen=True)
class ObjectText:
    """What turns the objects of a translated scene into text; with photons, specular ones are their targets."""

    translation: Translation
    _made: dict[Solid, Primitive] = field(default_factory=dict, repr=False)
    _partly: dict[int, tuple[int, ...]] = field(default_factory=dict, repr=False)

    @property
    def scene(self) -> Scene:
        return self.world.scene

    @property
    def world(self) -> World:
        return self.translation.world

    @property
    def units(self) -> Normalisation:
        return self.translation.units

    @property
    def nesting(self) -> Nesting:
        return self.translation.bodies.nesting

    def sdl(self, index: int, placed: Solid, exposure: Exposure, is_shooting: bool) -> Block:
        """The object in one run; ``placed`` is its shape, where a gap has been opened already."""
        return self.shaped(index, placed, exposure, self.look(index, placed, exposure, is_shooting))

    def look(self, index: int, placed: Solid, exposure: Exposure, is_shooting: bool) -> tuple[Part, ...]:
        """What stands after the shape of an object: textures, inside, and what photons do with it."""
        material = self.scene.material_of(self.scene.objects[index])
        look = (*self._textures(index, placed, exposure), *self._interior(material, exposure, is_shooting))
        photons = self._photons(material)
        return look if photons is None else (*look, photons)

    def shaped(self, index: int, placed: Solid, exposure: Exposure, look: tuple[Part, ...]) -> Block:
        """The shape of an object, cut by solids of higher priority, with a look."""
        material, cuts = self.scene.material_of(self.scene.objects[index]), self.nesting.cuts[index]
        shape = self._primitive(placed)
        if not cuts:
            return block(shape.keyword, *shape.parts, *look)
        return block("difference", shape.sdl, *(self._cutter(cut, material, exposure) for cut in cuts), *look)

    def _primitive(self, solid: Solid) -> Primitive:
        """The shape of a solid, made once for all runs: a mesh has many numbers."""
        if solid not in self._made:
            self._made[solid] = primitive(solid, self.units)
        return self._made[solid]

    def _cutter(self, cut: Cut, lower: Material, exposure: Exposure) -> Block:
        """What is taken out; its face belongs to the higher solid, and is clear from the inside of the lower one."""
        inner = self._primitive(cut.placed)
        if not lower.is_transmissive:
            return block(inner.keyword, *inner.parts, *self._layers(lower, cut.placed, exposure))
        higher = self.scene.material_of(self.scene.objects[cut.by])
        outer = self._layers(higher, cut.placed, exposure)
        # Say both sides: a part without a look of its own for its inside takes that of the whole.
        hidden = outer if cut.is_air else (self._second_face(lower, cut.is_contact, exposure),)
        return block(inner.keyword, *inner.parts, *outer, *as_interior(hidden))

    def _second_face(self, lower: Material, is_contact: bool, exposure: Exposure) -> Block:
        """The face at equal index that is crossed second: nothing, or what the lower solid's own face keeps."""
        if not is_contact:
            return CLEAR
        kept = specular_pool(lower, exposure) if lower.fresnel else exposure.share(lower.transmission)
        return block("texture", block("pigment", statement(rgb(kept), "filter", 1)))

    def _without(self, host: int, index: int) -> Block:
        """The room of a lower solid without those that other solids take from it."""
        body = self._primitive(self.world.solids[host]).sdl
        others = [self._primitive(cut.placed).sdl for cut in self.nesting.cuts[host] if cut.by != index]
        return block("difference", body, *others) if others else body

    def _layers(
        self, material: Material, placed: Solid, exposure: Exposure, bumps: Bumps | None = None, seen: float = 1.0
    ) -> Layers:
        return textures_sdl(Surface(material, placed, exposure, self.units, self._has_ambient, bumps, seen))

    def _textures(self, index: int, placed: Solid, exposure: Exposure) -> Layers:
        """The look of an object from outside, and where it differs from inside: rough, scattering and nested glass."""
        item = self.scene.objects[index]
        material, ior = self.scene.material_of(item), reference_ior(self.scene.material_of(item))
        around = self._seen_in(glass_around(self.world, index), exposure)
        bumps = [bumps_of(material, ior, from_inside=side) if material.is_specular else None for side in (False, True)]
        outer = self._layers(material, placed, exposure, bumps[0], around)
        if not material.is_transmissive:
            for glass in self._glass_on(index):
                # Where glass lies on this face, or around it, its radiance is seen from inside the glass.
                covered = self._layers(material, placed, exposure, bumps[0], self._seen_in(glass, exposure))
                outer = (_by_place(self._without(glass, index), outer, covered),)
            return outer
        inner = self._layers(material, placed, exposure, bumps[1], self._seen_in(index, exposure))
        for host in self.nesting.hosts[index]:
            # Where the lower solid lies outside, light has left this one already when it meets this face.
            is_contact = any(cut.by == index and cut.is_contact for cut in self.nesting.cuts[host])
            left = self._second_face(self.scene.material_of(self.scene.objects[host]), is_contact, exposure)
            inner = (_by_place(self._without(host, index), inner, (left,)),)
        return outer if inner == outer else (*outer, *as_interior(inner))

    def _glass_on(self, index: int) -> tuple[int, ...]:
        """The glasses around a part of an opaque body's surface: those that lie on it, and those it reaches into."""
        lying = self.translation.bodies.joined.under.get(index, ())
        if index not in self._partly:
            self._partly[index] = partly_around(self.world, index)
        return (*lying, *(glass for glass in self._partly[index] if glass not in lying))

    def _seen_in(self, glass: int | None, exposure: Exposure) -> float:
        """What the camera sees of a radiance that is sent out inside a glass, at the indices of the run."""
        at_camera, there = self._index_in(glass_at_camera(self.world), exposure), self._index_in(glass, exposure)
        return (at_camera / there) ** 2

    def _index_in(self, glass: int | None, exposure: Exposure) -> float:
        return 1.0 if glass is None else self.translation.indices.shown(self.world.material(glass), exposure)

    @property
    def _has_ambient(self) -> bool:
        return isinstance(self.scene.transport.indirect, Ambient) and self.translation.plan.requires(
            Phenomenon.INDIRECT_LIGHT
        )

    def _interior(self, material: Material, exposure: Exposure, is_shooting: bool) -> tuple[Part, ...]:
        """The index where light enters or Fresnel asks for it, and the absorption where the plan wants it.

        A medium absorbs on every way inside. POV-Ray's fade would not: it dims what leaves through a face of its own
        solid, and neither what the face mirrors back nor what ends on a body inside [P 7].
        """
        if not material.is_transmissive and not (material.fresnel and material.is_specular):
            return ()
        inside = self._absorption(material, exposure) if material.is_transmissive else None
        interior = block("interior", *self.translation.indices.sdl(material, exposure, is_shooting), inside)
        return (interior, statement("hollow")) if self._has_media and material.is_transmissive else (interior,)

    def _absorption(self, material: Material, exposure: Exposure) -> Block | None:
        """The medium of a glass that takes light in this run."""
        if not self.translation.plan.requires(Phenomenon.ABSORPTION):
            return None
        per_unit = exposure.share(self._absorption_per_unit(material))
        return block("media", statement("absorption", rgb(per_unit))) if max(per_unit) > 0 else None

    @property
    def _has_media(self) -> bool:
        """Whether something absorbs: then every solid that light crosses must be hollow, or its media are skipped."""
        absorbs = any(max(absorption_per_m(each)) > 0 for each in self.scene.materials.values())
        return absorbs and self.translation.plan.requires(Phenomenon.ABSORPTION)

    def _absorption_per_unit(self, material: Material) -> Triplet:
        red, green, blue = absorption_per_m(material)
        return (red / self.units.scale, green / self.units.scale, blue / self.units.scale)

    def _photons(self, material: Material) -> Block | None:
        """Photons are aimed at everything specular; only what scatters collects them."""
        if self.translation.photons is None or not material.is_specular:
            return None
        return block(
            "photons",
            statement("target"),
            statement("refraction", "on" if material.is_transmissive else "off"),
            statement("reflection", "on" if max(material.reflection) > 0 or material.fresnel else "off"),
            None if material.is_diffuse else statement("collect", "off"),
        )


def _by_place(body: Block, outside: Layers, inside: Layers) -> Block:
    """A texture that is one outside of a body and another inside it."""
    return block("texture", block("object", body, *outside, *inside))
