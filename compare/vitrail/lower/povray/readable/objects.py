"""The objects of a scene with their materials declared by name; meshes in files beside."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from vitrail.lower.povray.readable.identifiers import Identifiers, file_stem
from vitrail.lower.povray.readable.placing import as_written
from vitrail.lower.povray.text.edit import Edit, edited, values_of
from vitrail.lower.povray.text.exposure import Exposure
from vitrail.lower.povray.text.objects import ObjectText
from vitrail.lower.povray.text.sdl import (
    Blank,
    Block,
    Comment,
    Declaration,
    Identifier,
    Include,
    Part,
    Quoted,
    SdlFile,
    Statement,
    Table,
    block,
    statement,
)
from vitrail.lower.povray.translation import Translation
from vitrail.scene.model import Scene

Look = tuple[Part, ...]
LOOK = frozenset({"texture", "interior_texture", "interior"})
"""What a ``material`` of POV-Ray holds."""


@dataclass(frozen=True)
class Objects:
    """Declarations of materials, the objects, and the files of meshes that they include."""

    materials: tuple[Part, ...]
    parts: tuple[Part, ...]
    beside: dict[str, SdlFile]


@dataclass
class _Meshes:
    """Meshes that have been met, by their tables: a name for each, and a file to declare it in."""

    identifiers: Identifiers
    stem: str
    names: dict[tuple[Part, ...], Identifier] = field(default_factory=dict)
    files: dict[str, SdlFile] = field(default_factory=dict)

    def taken_out(self, name: str) -> Edit:
        """Put the name of a mesh in the place of its triangles."""

        def edit(part: Part) -> Part:
            if not isinstance(part, Block) or part.head != "mesh2":
                return part
            tables = tuple(each for each in part.parts if _is_of_mesh(each))
            if tables not in self.names:
                mesh = self.identifiers.new(name, prefix="Mesh_")
                self.names[tables] = mesh
                self.files[f"{self.stem}_{file_stem(mesh.name)}.inc"] = SdlFile(
                    (Declaration(mesh, Block("mesh2", tables)),)
                )
            rest = tuple(each for each in part.parts if not _is_of_mesh(each))
            return Block("object", (statement(self.names[tables]), *rest))

        return edit


def readable_objects(translation: Translation, exposure: Exposure, identifiers: Identifiers, stem: str) -> Objects:
    """Every object by its name, with its material by the name of the scene."""
    texts, meshes = ObjectText(translation), _Meshes(identifiers, stem)
    placed = {
        index: solid
        for index, solid in enumerate(translation.bodies.placement.placed)
        if index not in translation.bodies.nesting.omitted
    }
    looks = {index: texts.look(index, solid, exposure, is_shooting=False) for index, solid in placed.items()}
    materials, named = _declared(translation.scene, looks, identifiers)
    parts: list[Part] = []
    for index, solid in placed.items():
        item = translation.scene.objects[index]
        material = named[item.material, _material_of(looks[index])]
        look = (block("material", statement(material)), *_beside(looks[index]))
        whole = SdlFile((texts.shaped(index, solid, exposure, look),))
        whole = edited(edited(whole, meshes.taken_out(item.name)), as_written(item, translation.units))
        (body,) = whole.parts
        identifier = identifiers.new(item.name)
        cut = ", cut by what has a higher priority" if translation.bodies.nesting.cuts[index] else ""
        parts += [Blank(), Comment(f"{item.name}: a {item.shape.key} of {item.material}{cut}")]
        parts += [Declaration(identifier, body), block("object", statement(identifier))]
    declared = edited(SdlFile(tuple(materials)), meshes.taken_out("part")).parts
    includes = tuple(Include(Quoted(file)) for file in meshes.files)
    return Objects((*includes, *declared), tuple(parts), meshes.files)


def _declared(
    scene: Scene, looks: Mapping[int, Look], identifiers: Identifiers
) -> tuple[list[Part], dict[tuple[str, Look], Identifier]]:
    """A declaration for each material and look: the most usual look of a material has its plain name.

    A material looks different on an object whose face lies on glass, or whose checker lies elsewhere.
    """
    users: dict[tuple[str, Look], list[str]] = {}
    for index, look in looks.items():
        item = scene.objects[index]
        users.setdefault((item.material, _material_of(look)), []).append(item.name)
    parts: list[Part] = []
    named: dict[tuple[str, Look], Identifier] = {}
    for name in scene.materials:
        found = sorted((key for key in users if key[0] == name), key=lambda key: -len(users[key]))
        for count, key in enumerate(found):
            of = f"{name} of {users[key][0]}" if count else name
            named[key] = identifiers.new(of, prefix="M_")
            parts += [Blank(), Comment(f"{name}: the material of {', '.join(users[key])}")]
            if any(_disperses(part) for part in key[1]):
                parts.append(Comment("raise dispersion_samples to 16 or more for a smooth spectrum"))
            parts.append(Declaration(named[key], Block("material", key[1])))
    return parts, named


def _material_of(look: tuple[Part, ...]) -> tuple[Part, ...]:
    return tuple(part for part in look if isinstance(part, Block) and part.head in LOOK)


def _disperses(part: Part) -> bool:
    return isinstance(part, Block) and part.head == "interior" and values_of(part, "dispersion") is not None


def _beside(look: tuple[Part, ...]) -> tuple[Part, ...]:
    """What belongs to the object itself: ``hollow``, and its photons."""
    return tuple(part for part in look if not (isinstance(part, Block) and part.head in LOOK))


def _is_of_mesh(part: Part) -> bool:
    return isinstance(part, Table) or (isinstance(part, Statement) and part.keyword == "inside_vector")
