"""The lights of a scene; a file writes what emits under its ``key``."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from vitrail.base.fault import Fault
from vitrail.scene.model.by_key import ByKey, OneByKey
from vitrail.scene.model.directions import refuse_zero
from vitrail.scene.model.part import Colour, Part, Vector
from vitrail.scene.model.shapes import Disc, Rectangle


class Directional(Part):
    """Light from infinity; ``irradiance`` is that of a facing surface, W/m2."""

    key: ClassVar[str] = "directional"

    direction: Vector
    irradiance: Colour
    angular_diameter_deg: Annotated[float, Field(ge=0, lt=90, strict=True)] = 0.0

    @model_validator(mode="after")
    def _has_a_direction(self) -> Directional:
        refuse_zero(self.direction, "direction")
        return self


class Point(Part):
    """``intensity`` in W/sr; irradiance falls with the square of the distance."""

    key: ClassVar[str] = "point"

    position: Vector
    intensity: Colour


class Spot(Part):
    """A point light limited to a cone of full angle ``cone_deg``, with a sharp edge."""

    key: ClassVar[str] = "spot"

    position: Vector
    direction: Vector
    intensity: Colour
    cone_deg: Annotated[float, Field(gt=0, lt=180, strict=True)]

    @model_validator(mode="after")
    def _has_a_direction(self) -> Spot:
        refuse_zero(self.direction, "direction")
        return self


class Area(OneByKey):
    """A one-sided Lambertian emitter of ``radiance``, or with ``collimated`` the lamp of figure 4.

    The collimated lamp sends all its light along the normal and takes ``irradiance``.
    """

    key: ClassVar[str] = "area"
    chosen: ClassVar[str] = "shape"

    shape: Annotated[Rectangle | Disc, ByKey()]
    radiance: Colour | None = None
    collimated: Annotated[bool, Field(strict=True)] = False
    irradiance: Colour | None = None

    @classmethod
    def miscounted(cls, given: list[str]) -> Fault:
        return Fault("an area light has exactly one shape, `rectangle` or `disc`", "change it")

    @model_validator(mode="after")
    def _has_its_strength(self) -> Area:
        if self.collimated and (self.irradiance is None or self.radiance is not None):
            raise Fault("a collimated area light takes `irradiance` (W/m2), not `radiance`", "change it")
        if not self.collimated and (self.radiance is None or self.irradiance is not None):
            raise Fault("an area light takes `radiance`", "`irradiance` goes with `collimated: true`")
        return self

    @property
    def strength(self) -> tuple[float, float, float]:
        """Irradiance, W/m2, of a collimated lamp, and radiance, W/(m2 sr), of any other."""
        found = self.irradiance if self.collimated else self.radiance
        assert found is not None, "refused by _has_its_strength"
        return found


class Environment(Part):
    """Constant radiance from everywhere, or a lat-long EXR image."""

    key: ClassVar[str] = "environment"

    radiance: Colour | None = None
    file: str | None = None

    @model_validator(mode="after")
    def _has_a_source(self) -> Environment:
        if (self.radiance is None) == (self.file is None):
            raise Fault("an environment has exactly one source, `radiance` or `file`", "change it")
        return self


Emitter = Directional | Point | Spot | Area | Environment
"""Everything that a light may be."""


class Light(OneByKey):
    chosen: ClassVar[str] = "emitter"

    name: str
    emitter: Annotated[Emitter, ByKey()]

    @classmethod
    def miscounted(cls, given: list[str]) -> Fault:
        found = " and ".join(given) if given else "none"
        return Fault(f"a light has exactly one kind, this one has {found}", f"the kinds are {', '.join(cls.kinds())}")
