"""Shapes that cannot exist, and patterns that have nowhere to lie."""

from __future__ import annotations

from vitrail.check.files import file_problem
from vitrail.check.findings import Findings
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.solid import Solid
from vitrail.scene.model import Checker, Object


def check_shapes(findings: Findings) -> None:
    """Check each object by itself: its geometry, its pattern, its file."""
    for index, (item, solid) in enumerate(zip(findings.scene.objects, findings.world.solids, strict=True)):
        faults = list(solid.faults())
        for fault in faults:
            findings.error(fault.what, fault.remedy, "objects", index, item.shape.key, *fault.path)
        if isinstance(solid, PlacedMesh) and not faults:
            _check_file(findings, index, solid.shape.file)
        _check_pattern(findings, index, item, solid)


def _check_pattern(findings: Findings, index: int, item: Object, solid: Solid) -> None:
    """A checker needs the surface coordinates of a flat shape."""
    material = findings.scene.material_of(item)
    patterned = isinstance(material.diffuse, Checker) or isinstance(material.emission, Checker)
    if patterned and solid.surface_frame is None:
        what = f"`{item.name}` is a {item.shape.key}, and a checker lies on flat shapes only"
        remedy = "use plane, rectangle or disc, or give the material one colour"
        findings.error(what, remedy, "objects", index, "material")


def _check_file(findings: Findings, index: int, name: str) -> None:
    if (problem := file_problem(findings, name)) is not None:
        remedy = "paths are relative to the scene file; check this one"
        findings.error(problem, remedy, "objects", index, "mesh", "file")
