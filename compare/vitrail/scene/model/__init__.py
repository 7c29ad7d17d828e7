"""The scene language as types: what a scene file may say, in SI units, and nothing else.

Every model is frozen and refuses unknown keys. Checks that need one value (a radius above zero, ``d + r + t <= 1``)
live here; checks that need two places of a file (a dangling material, overlapping glass) live in ``check/``.
``load.py`` turns the faults raised here into ``file:line:col`` messages, ``schema.py`` prints the types as JSON Schema.

Vectors are ``(x, y, z)`` in metres, right-handed, +y up. Colours are linear Rec. 709 / D65 triplets.
"""

from vitrail.scene.model.lights import Area, Directional, Emitter, Environment, Light, Point, Spot
from vitrail.scene.model.material import Abbe, Attenuation, Checker, CheckerSquares, Ggx, Glass, Material
from vitrail.scene.model.objects import Object
from vitrail.scene.model.part import Part, Vector
from vitrail.scene.model.scene import Scene
from vitrail.scene.model.shapes import (
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
    Shape,
    Sphere,
    Torus,
)
from vitrail.scene.model.transport import Ambient, Paper, SpectralBands, Transport
from vitrail.scene.model.view import Camera, Image, Observation, Orthographic, Patch, Perspective

__all__ = [
    "Abbe",
    "Ambient",
    "Area",
    "Attenuation",
    "Box",
    "Camera",
    "Checker",
    "CheckerSquares",
    "Cone",
    "Cylinder",
    "Directional",
    "Disc",
    "Emitter",
    "Environment",
    "Ggx",
    "Glass",
    "Image",
    "Lathe",
    "Lens",
    "Light",
    "Material",
    "Mesh",
    "Object",
    "Observation",
    "Orthographic",
    "Paper",
    "Part",
    "Patch",
    "Perspective",
    "Plane",
    "Point",
    "Prism",
    "Rectangle",
    "Scene",
    "Shape",
    "SpectralBands",
    "Sphere",
    "Spot",
    "Torus",
    "Transport",
    "Vector",
]
