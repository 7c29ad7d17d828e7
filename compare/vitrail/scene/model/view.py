"""Who looks, and at what: the camera, the image, and the patches on which a phenomenon is measured."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field, model_validator

from vitrail.base.fault import Fault
from vitrail.base.phenomenon import Phenomenon
from vitrail.base.vector import cross, length, subtract
from vitrail.scene.model.directions import refuse_slant, refuse_zero
from vitrail.scene.model.part import Finite, Part, Positive, Vector


@dataclass(frozen=True)
class Perspective:
    """All lines of sight meet in the camera; ``fov_deg`` is the vertical angle of the picture."""

    fov_deg: float


@dataclass(frozen=True)
class Orthographic:
    """All lines of sight are parallel; ``height`` is that of the picture, metres."""

    height: float


class Camera(Part):
    """Perspective with a vertical ``fov_deg``, or ``kind: orthographic`` with ``height`` in metres."""

    kind: Literal["perspective", "orthographic"] = "perspective"
    position: Vector
    look_at: Vector
    up: Vector = (0.0, 1.0, 0.0)
    fov_deg: Annotated[float, Field(gt=0, lt=180, strict=True)] | None = None
    height: Positive | None = None

    @model_validator(mode="after")
    def _is_complete(self) -> Camera:
        forward = subtract(self.look_at, self.position)
        if length(forward) == 0:
            raise Fault("the camera looks at its own position", "move `look_at` or `position`")
        if self.kind == "perspective" and (self.fov_deg is None or self.height is not None):
            raise Fault("a perspective camera takes `fov_deg`", "`height` goes with `kind: orthographic`")
        if self.kind == "orthographic" and (self.height is None or self.fov_deg is not None):
            raise Fault("an orthographic camera takes `height`", "`fov_deg` goes with a perspective camera")
        if length(cross(forward, self.up)) <= 1e-12 * length(forward) * length(self.up):
            raise Fault("`up` is along the view direction", "choose another, for example `up: [0, 0, 1]`")
        return self

    @property
    def projection(self) -> Perspective | Orthographic:
        """What its ``kind`` says, with the one number that goes with it."""
        if self.height is not None:
            return Orthographic(self.height)
        assert self.fov_deg is not None, "refused by _is_complete"
        return Perspective(self.fov_deg)


class Image(Part):
    width: Annotated[int, Field(ge=1, le=16384, strict=True)]
    height: Annotated[int, Field(ge=1, le=16384, strict=True)]
    exposure_stops: Finite = 0.0
    samples: Annotated[int, Field(ge=1, le=65536, strict=True)] | None = None


class Patch(Part):
    """A rectangle on a receiver: ``center + a u + b v`` for a, b in [-1, 1], metres."""

    center: Vector
    u: Vector
    v: Vector

    @model_validator(mode="after")
    def _has_an_area(self) -> Patch:
        refuse_zero(self.u, "u")
        refuse_zero(self.v, "v")
        refuse_slant(self.u, self.v)
        return self


class Observation(Part):
    """One phenomenon, measured on one patch."""

    name: str
    phenomenon: Phenomenon
    patch: Patch
    along: Literal["u", "v"] | None = None
    pattern: str | None = None
