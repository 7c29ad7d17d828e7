"""Shapes as the tracer reads them: moved into the world, or with the frame that moves them."""

from __future__ import annotations

from typing import Any, assert_never

from vitrail.base.packed_numbers import pack
from vitrail.base.vector import unit
from vitrail.geometry.frame import Frame
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.solid import Solid
from vitrail.scene.model import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Lathe,
    Lens,
    Mesh,
    Plane,
    Prism,
    Rectangle,
    Sphere,
    Torus,
)

Json = dict[str, Any]


def lowered_shape(solid: Solid) -> Json:
    """One shape; normals come out with unit length."""
    shape, frame = solid.shape, lowered_frame(solid.frame)
    match shape:
        case Sphere():
            return {"kind": "sphere", "center": shape.center, "radius": shape.radius}
        case Plane():
            return {"kind": "plane", "point": shape.point, "normal": unit(shape.normal)}
        case Rectangle() | Disc():
            return flat_shape(shape)
        case Box():
            return {"kind": "box", "min": shape.min, "max": shape.max, "frame": frame}
        case Cylinder():
            return {"kind": "cylinder", "from": shape.from_, "to": shape.to, "radius": shape.radius}
        case Cone():
            ends = {"radius_from": shape.radius_from, "radius_to": shape.radius_to}
            return {"kind": "cone", "from": shape.from_, "to": shape.to, **ends}
        case Prism():
            return {"kind": "prism", "corners": shape.corners, "height": shape.height, "frame": frame}
        case Lens():
            return {"kind": "lens", **shape.model_dump(), "frame": frame}
        case Torus():
            return {"kind": "torus", **shape.model_dump(), "normal": unit(shape.normal)}
        case Lathe():
            return {"kind": "lathe", "profile": shape.profile, "frame": frame}
        case Mesh():
            assert isinstance(solid, PlacedMesh)
            return {"kind": "mesh", **_triangles(solid), "smooth": shape.smooth, "frame": frame}
        case _:
            assert_never(shape)


def _triangles(mesh: PlacedMesh) -> Json:
    """What its file holds, in the axes of the file; the tracer places it. It is read here and nowhere else."""
    read = mesh.read
    normals = {} if read.normals is None else {"normals": pack(read.normals, "f8")}
    return {"vertices": pack(read.vertices, "f8"), "triangles": pack(read.triangles, "u4"), **normals}


def flat_shape(shape: Rectangle | Disc) -> Json:
    """A rectangle or disc that already stands in the world, as an object or as a lamp."""
    match shape:
        case Rectangle():
            return {"kind": "rectangle", "center": shape.center, "u": shape.u, "v": shape.v}
        case Disc():
            return {"kind": "disc", "center": shape.center, "normal": unit(shape.normal), "radius": shape.radius}
        case _:
            assert_never(shape)


def lowered_frame(frame: Frame) -> Json:
    return {"origin": frame.origin, "rotation": frame.rotation, "identity": frame.is_identity}
