"""The objects of a scene: a name, a material, one shape, and where it is."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from vitrail.base.fault import Fault
from vitrail.scene.model.by_key import ByKey, OneByKey
from vitrail.scene.model.part import Vector
from vitrail.scene.model.shapes import Shape


class Object(OneByKey):
    """One named shape with its material; rotated about the origin by x, then y, then z, and then moved."""

    chosen: ClassVar[str] = "shape"

    name: str
    material: str
    shape: Annotated[Shape, ByKey()]
    rotate_deg: Vector = (0.0, 0.0, 0.0)
    translate: Vector = (0.0, 0.0, 0.0)
    priority: Annotated[int, Field(ge=0, le=1000, strict=True)] | None = None

    @classmethod
    def miscounted(cls, given: list[str]) -> Fault:
        found = " and ".join(given) if given else "none"
        return Fault(
            f"an object has exactly one shape, this one has {found}", f"the shapes are {', '.join(cls.kinds())}"
        )
