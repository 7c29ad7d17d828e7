"""From a shape of the language to the solid that stands for it: the one place that knows every family of shapes."""

from __future__ import annotations

import os
from pathlib import Path
from typing import assert_never

from vitrail.geometry.frame import Frame, frame_of
from vitrail.geometry.shapes.axial import PlacedCone, PlacedCylinder
from vitrail.geometry.shapes.box import PlacedBox
from vitrail.geometry.shapes.flat import PlacedDisc, PlacedPlane, PlacedRectangle
from vitrail.geometry.shapes.lathe import PlacedLathe
from vitrail.geometry.shapes.lens import PlacedLens
from vitrail.geometry.shapes.mesh import PlacedMesh
from vitrail.geometry.shapes.prism import PlacedPrism
from vitrail.geometry.shapes.sphere import PlacedSphere
from vitrail.geometry.shapes.torus import PlacedTorus
from vitrail.geometry.solid import Solid
from vitrail.scene.model import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Lathe,
    Lens,
    Mesh,
    Object,
    Plane,
    Prism,
    Rectangle,
    Shape,
    Sphere,
    Torus,
)


def place(item: Object, folder: Path | None = None) -> Solid:
    """An object where its rotation and translation put it; a mesh is sought in ``folder``, or not read without it."""
    return solid_of(item.shape, folder).moved(frame_of(item))


def solid_of(shape: Shape, folder: Path | None = None) -> Solid:
    """A shape in its own axes."""
    own = Frame()
    match shape:
        case Sphere():
            return PlacedSphere(shape, own)
        case Plane():
            return PlacedPlane(shape, own)
        case Rectangle():
            return PlacedRectangle(shape, own)
        case Disc():
            return PlacedDisc(shape, own)
        case Box():
            return PlacedBox(shape, own)
        case Cylinder():
            return PlacedCylinder(shape, own)
        case Cone():
            return PlacedCone(shape, own)
        case Prism():
            return PlacedPrism(shape, own)
        case Lens():
            return PlacedLens(shape, own)
        case Torus():
            return PlacedTorus(shape, own)
        case Lathe():
            return PlacedLathe(shape, own)
        case Mesh():
            return PlacedMesh(shape, own, None if folder is None else Path(os.path.realpath(folder / shape.file)))
        case _:
            assert_never(shape)
