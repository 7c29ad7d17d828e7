"""What the files of meshes hold: triangles at all, and for glass a closed surface that faces outwards everywhere."""

from __future__ import annotations

from vitrail.check.findings import Findings
from vitrail.geometry.mesh_file import MeshFileError
from vitrail.geometry.mesh_of import solid_of
from vitrail.geometry.mesh_solid import fault_of_solid
from vitrail.geometry.placement import place
from vitrail.scene.model import Mesh


def check_meshes(findings: Findings) -> None:
    """Refuse meshes that cannot be read, and those of glass that enclose nothing."""
    for index, item in enumerate(findings.with_full_paths.objects):
        if not isinstance(item.shape, Mesh) or index in findings.broken_objects:
            continue
        path, file = ("objects", index, "mesh", "file"), findings.scene.objects[index].shape
        assert isinstance(file, Mesh)
        try:
            solid = solid_of(place(item))
        except MeshFileError as error:
            findings.error(f"`{file.file}` is of no use: {error}", "write it again as PLY or OBJ", *path)
            continue
        assert solid is not None
        if not findings.scene.material_of(item).is_transmissive:
            continue
        if (fault := fault_of_solid(solid)) is not None:
            what = f"`{file.file}` {fault}, and `{item.name}` is of glass"
            findings.error(what, "close the mesh with outward triangles, or take an opaque material", *path)
