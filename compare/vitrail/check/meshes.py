"""What the files of meshes hold: triangles at all, and for glass a closed surface that faces outwards everywhere."""

from __future__ import annotations

from vitrail.check.findings import Findings
from vitrail.geometry.mesh_file import MeshFileError
from vitrail.geometry.shapes.mesh import PlacedMesh


def check_meshes(findings: Findings) -> None:
    """Refuse meshes that cannot be read, and those of glass that enclose nothing."""
    for index, mesh in enumerate(findings.world.solids):
        if not isinstance(mesh, PlacedMesh) or index in findings.broken_objects:
            continue
        path, file, item = ("objects", index, "mesh", "file"), mesh.shape.file, findings.scene.objects[index]
        try:
            solid = mesh.known
        except MeshFileError as error:
            findings.error(f"`{file}` is of no use: {error}", "write it again as PLY or OBJ", *path)
            continue
        if not findings.scene.material_of(item).is_transmissive:
            continue
        # SciPy takes long to import, and few scenes have a mesh.
        from vitrail.geometry.mesh_solid import fault_of_solid

        if (fault := fault_of_solid(solid)) is not None:
            what = f"`{file}` {fault.what}, and `{item.name}` is of glass"
            findings.error(what, fault.remedy, *path)
