"""A whole scene file."""

from __future__ import annotations

from typing import Literal

from vitrail.scene.model.lights import Light
from vitrail.scene.model.material import Material
from vitrail.scene.model.objects import Object
from vitrail.scene.model.part import Part
from vitrail.scene.model.transport import Paper, Transport
from vitrail.scene.model.view import Camera, Image, Observation


class Scene(Part):
    """A whole scene file."""

    vitrail: Literal[1]
    title: str = ""
    camera: Camera
    image: Image
    materials: dict[str, Material]
    objects: tuple[Object, ...]
    lights: tuple[Light, ...]
    transport: Transport = Transport()
    paper: Paper = Paper()
    observe: tuple[Observation, ...] = ()

    def material_of(self, item: Object) -> Material:
        return self.materials[item.material]
