"""The shapes of objects, one class each; a file writes a shape under its ``key``."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from vitrail.base.fault import Fault
from vitrail.scene.model.directions import refuse_same, refuse_slant, refuse_zero
from vitrail.scene.model.part import Finite, NotNegative, Part, Positive, Vector


class Sphere(Part):
    key: ClassVar[str] = "sphere"

    center: Vector
    radius: Positive


class Plane(Part):
    """An infinite plane; its surface coordinates are those of ``tangents`` in ``geometry/surface.py``."""

    key: ClassVar[str] = "plane"

    point: Vector
    normal: Vector

    @model_validator(mode="after")
    def _has_a_direction(self) -> Plane:
        refuse_zero(self.normal, "normal")
        return self


class Rectangle(Part):
    """``center + a u + b v`` for a, b in [-1, 1]; ``u`` and ``v`` are perpendicular half edges, normal ``u x v``."""

    key: ClassVar[str] = "rectangle"

    center: Vector
    u: Vector
    v: Vector

    @model_validator(mode="after")
    def _has_an_area(self) -> Rectangle:
        refuse_zero(self.u, "u")
        refuse_zero(self.v, "v")
        refuse_slant(self.u, self.v)
        return self


class Disc(Part):
    key: ClassVar[str] = "disc"

    center: Vector
    normal: Vector
    radius: Positive

    @model_validator(mode="after")
    def _has_a_direction(self) -> Disc:
        refuse_zero(self.normal, "normal")
        return self


class Box(Part):
    key: ClassVar[str] = "box"

    min: Vector
    max: Vector

    @model_validator(mode="after")
    def _has_a_volume(self) -> Box:
        for axis, low, high in zip("xyz", self.min, self.max, strict=True):
            if not low < high:
                raise Fault(f"min.{axis} = {low:g} is not below max.{axis} = {high:g}", "exchange or move them")
        return self


class Cylinder(Part):
    """Closed by its two end discs."""

    key: ClassVar[str] = "cylinder"

    from_: Vector = Field(alias="from")
    to: Vector
    radius: Positive

    @model_validator(mode="after")
    def _has_a_length(self) -> Cylinder:
        refuse_same(self.from_, self.to)
        return self


class Cone(Part):
    """A closed frustum; one of the radii may be 0."""

    key: ClassVar[str] = "cone"

    from_: Vector = Field(alias="from")
    to: Vector
    radius_from: NotNegative
    radius_to: NotNegative

    @model_validator(mode="after")
    def _has_a_volume(self) -> Cone:
        refuse_same(self.from_, self.to)
        if self.radius_from == self.radius_to:
            raise Fault("radius_from and radius_to are equal", "use `cylinder`")
        return self


class Prism(Part):
    """A polygon in x, y extruded along z, centred on z = 0.

    It is given by ``profile`` and ``height``, or by ``apex_deg``, ``side`` and ``height``.

    With ``apex_deg`` the cross-section is isosceles: two sides of length ``side`` meet at the apex, which points to +y;
    the centroid is the origin.
    """

    key: ClassVar[str] = "prism"

    height: Positive
    profile: tuple[tuple[Finite, Finite], ...] | None = None
    apex_deg: Annotated[float, Field(gt=0, lt=180, strict=True)] | None = None
    side: Positive | None = None

    @model_validator(mode="after")
    def _has_a_cross_section(self) -> Prism:
        by_apex = self.apex_deg is not None and self.side is not None
        if (self.profile is not None) == by_apex or (self.apex_deg is None) != (self.side is None):
            raise Fault("a prism needs one cross-section", "give `profile` (corners [x, y]), or `apex_deg` and `side`")
        if self.profile is not None and len(self.profile) < 3:
            raise Fault("a profile needs at least three corners", "add some")
        return self

    @property
    def corners(self) -> tuple[tuple[float, float], ...]:
        """The cross-section, counter-clockwise in the x, y plane, metres."""
        if self.profile is not None:
            area = sum(
                a[0] * b[1] - b[0] * a[1]
                for a, b in zip(self.profile, self.profile[1:] + self.profile[:1], strict=True)
            )
            return self.profile if area > 0 else tuple(reversed(self.profile))
        assert self.apex_deg is not None and self.side is not None, "refused by _has_a_cross_section"
        half = math.radians(self.apex_deg) / 2
        base, rise = self.side * math.sin(half), self.side * math.cos(half)
        return ((-base, -rise / 3), (base, -rise / 3), (0.0, 2 * rise / 3))


class Lens(Part):
    """Two spherical faces about the z axis, centred on the origin; positive radii are convex, 0 is flat.

    The front face has its vertex at z = -thickness / 2 (light along +z meets it first), the back face at +z.

    ``thickness`` is at the axis, ``diameter`` that of the cylindrical rim.
    """

    key: ClassVar[str] = "lens"

    radius_front: Finite
    radius_back: Finite
    thickness: Positive
    diameter: Positive


class Torus(Part):
    """A ring torus: what lies within ``radius_tube`` of a circle of ``radius`` about ``center``, across ``normal``."""

    key: ClassVar[str] = "torus"

    center: Vector
    normal: Vector
    radius: Positive
    radius_tube: Positive

    @model_validator(mode="after")
    def _has_a_hole(self) -> Torus:
        refuse_zero(self.normal, "normal")
        if not self.radius_tube < self.radius:
            what = f"a tube of radius {self.radius_tube:g} m fills its ring of radius {self.radius:g} m"
            raise Fault(what, "write a `radius_tube` below `radius`; `radius` goes to the middle of the tube")
        return self


class Lathe(Part):
    """A polygon of corners ``[radius, height]``, turned about the y axis; the last corner joins the first."""

    key: ClassVar[str] = "lathe"

    profile: tuple[tuple[NotNegative, Finite], ...]

    @model_validator(mode="after")
    def _has_a_cross_section(self) -> Lathe:
        if len(self.profile) < 3:
            raise Fault("a profile needs at least three corners", "add some")
        return self


class Mesh(Part):
    """Triangles from a PLY or OBJ file beside the scene; closed and outward if the material transmits."""

    key: ClassVar[str] = "mesh"

    file: str
    smooth: Annotated[bool, Field(strict=True)] = True


Shape = Sphere | Plane | Rectangle | Disc | Box | Cylinder | Cone | Prism | Lens | Torus | Lathe | Mesh
"""Every shape that an object may have."""
