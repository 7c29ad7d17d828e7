"""The scene language as types: what a scene file may say, in SI units, and nothing else.

Every model is frozen and refuses unknown keys. Checks that need one value (a radius above zero, ``d + r + t <= 1``)
live here; checks that need two places of a file (a dangling material, overlapping glass) live in ``check.py``.
``load.py`` turns the errors raised here into ``file:line:col`` messages, ``schema.py`` prints the types as JSON Schema.

Vectors are ``(x, y, z)`` in metres, right-handed, +y up. Colours are linear Rec. 709 / D65 triplets.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, PrivateAttr, model_validator

from vitrail.base.phenomenon import Phenomenon

LIGHT_USE_SLACK = 4 * 2.220446049250313e-16
"""Decimal sums overshoot: .33 + .56 + .11 exceeds 1 by rounding alone, so 4 ulp are allowed [O 2.37]."""


class Part(BaseModel):
    """Base of every part of a scene: immutable, finite numbers only, unknown keys refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, strict=False)


def _triplet(value: Any) -> Any:
    """Spread one number over the three channels, so that ``0.8`` and ``[0.8, 0.8, 0.8]`` are the same colour."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return (value, value, value)
    return value


def _spread(channel: Any) -> BeforeValidator:
    """Accept one number for three channels; the schema shows both forms."""
    return BeforeValidator(_triplet, json_schema_input_type=channel | tuple[channel, channel, channel])


Finite = Annotated[float, Field(allow_inf_nan=False, strict=True)]
Positive = Annotated[float, Field(gt=0, allow_inf_nan=False, strict=True)]
NotNegative = Annotated[float, Field(ge=0, allow_inf_nan=False, strict=True)]
Vector = tuple[Finite, Finite, Finite]
Colour = Annotated[tuple[NotNegative, NotNegative, NotNegative], _spread(NotNegative)]
Fraction = Annotated[float, Field(ge=0, le=1, allow_inf_nan=False, strict=True)]
Share = Annotated[tuple[Fraction, Fraction, Fraction], _spread(Fraction)]


class CheckerSquares(Part):
    """Two colours in squares of ``size`` metres along the surface coordinates of a flat shape."""

    colors: tuple[Colour, Colour]
    size: Positive


class Checker(Part):
    """A pattern instead of one colour; flat shapes (plane, rectangle, disc) only."""

    checker: CheckerSquares


Texture = Colour | Checker
COLOUR_KEYS = (
    "diffuse",
    "reflection",
    "transmission",
    "emission",
    "color",
    "absorption_per_m",
    "irradiance",
    "intensity",
    "radiance",
    "ambient",
)
"""The keys whose value is a colour: one number, or three for red, green and blue."""


Glass = Literal[
    "N-BK7",
    "N-K5",
    "N-BAK4",
    "N-SK16",
    "N-LAK8",
    "N-LASF44",
    "F2",
    "N-F2",
    "SF10",
    "N-SF10",
    "SF11",
    "N-SF11",
    "N-SF66",
    "fused-silica",
    "water",
]
"""The catalogue glasses a scene may name; ``optics/glass.py`` holds their constants."""


# --- material -------------------------------------------------------------------------------------------------------


class Ggx(Part):
    """Microfacet roughness with the GGX distribution [W07 eq. 33]."""

    ggx: Annotated[float, Field(gt=0, le=1, strict=True)]


class Abbe(Part):
    """Dispersion from the Abbe number at the d line, V_d = (n_d - 1) / (n_F - n_C)."""

    abbe: Annotated[float, Field(gt=1, allow_inf_nan=False, strict=True)]


_Remaining = Annotated[float, Field(gt=0, le=1, strict=True)]


class Attenuation(Part):
    """White light has ``color`` left after ``distance`` metres inside (as in KHR_materials_volume)."""

    color: Annotated[tuple[_Remaining, _Remaining, _Remaining], _spread(_Remaining)]
    distance: Positive


class Material(Part):
    """The paper's material: shares d, r, t of the light that meets a face, and what the inside does to it.

    ``diffuse + reflection + transmission`` is the light use ``lu`` [S eq. 6]; it may not exceed 1 in any channel.
    """

    diffuse: Share | Checker = (0.0, 0.0, 0.0)
    reflection: Share = (0.0, 0.0, 0.0)
    transmission: Share = (0.0, 0.0, 0.0)
    ior: Positive | None = None
    fresnel: Annotated[bool, Field(strict=True)] = False
    roughness: Annotated[float, Field(ge=0, le=1, strict=True)] | Ggx = 0.0
    dispersion: Finite | Abbe | None = None
    glass: Glass | None = None
    attenuation: Attenuation | None = None
    absorption_per_m: Colour | None = None
    emission: Colour | Checker | None = None

    @property
    def diffuse_peak(self) -> tuple[float, float, float]:
        """The largest diffuse share per channel over the surface."""
        if isinstance(self.diffuse, Checker):
            first, second = self.diffuse.checker.colors
            return (max(first[0], second[0]), max(first[1], second[1]), max(first[2], second[2]))
        return self.diffuse

    @property
    def light_use(self) -> tuple[float, float, float]:
        """lu = d + r + t per channel [S eq. 6], at its largest over the surface."""
        d, r, t = self.diffuse_peak, self.reflection, self.transmission
        return (d[0] + r[0] + t[0], d[1] + r[1] + t[1], d[2] + r[2] + t[2])

    @property
    def is_diffuse(self) -> bool:
        return max(self.diffuse_peak) > 0

    @property
    def is_transmissive(self) -> bool:
        return max(self.transmission) > 0

    @property
    def is_specular(self) -> bool:
        """Whether light leaves a face of this material in a mirrored or refracted direction."""
        return max(self.reflection) > 0 or self.is_transmissive

    @property
    def is_dispersive(self) -> bool:
        return self.is_transmissive and (
            self.glass is not None or isinstance(self.dispersion, Abbe) or self.dispersion not in (None, 0.0)
        )

    @model_validator(mode="after")
    def _conserve_light(self) -> Material:
        use = max(self.light_use)
        if use > 1 + LIGHT_USE_SLACK:
            channel = ["red", "green", "blue"][self.light_use.index(use)]
            raise ValueError(
                f"diffuse + reflection + transmission is {use:.6g} in {channel}, which makes light;"
                " lower one of them until the sum is at most 1"
            )
        return self

    @model_validator(mode="after")
    def _need_an_index(self) -> Material:
        if self.is_transmissive and self.ior is None and self.glass is None:
            raise ValueError(
                "a transmissive material needs its refraction index; add `ior: 1.5` or a catalogue `glass:`"
            )
        if self.ior is not None and self.glass is not None:
            raise ValueError("both `ior` and `glass` give the refraction index; keep one of them")
        if self.glass is not None and self.dispersion is not None:
            raise ValueError("both `glass` and `dispersion` give the dispersion; keep one of them")
        if self.attenuation is not None and self.absorption_per_m is not None:
            raise ValueError("both `attenuation` and `absorption_per_m` give the absorption; keep one of them")
        if self.fresnel and self.ior is None and self.glass is None:
            raise ValueError("`fresnel` needs a refraction index; add `ior: 1.5` or a catalogue `glass:`")
        if (self.attenuation or self.absorption_per_m) and not self.is_transmissive:
            raise ValueError(
                "an opaque material has no inside to absorb light; add `transmission` or drop the absorption"
            )
        return self


# --- shapes ---------------------------------------------------------------------------------------------------------


class Sphere(Part):
    center: Vector
    radius: Positive


class Plane(Part):
    """An infinite plane; its surface coordinates are those of ``frame_of`` in ``geometry/surface.py``."""

    point: Vector
    normal: Vector

    @model_validator(mode="after")
    def _has_a_direction(self) -> Plane:
        _refuse_zero(self.normal, "normal")
        return self


class Rectangle(Part):
    """``center + a u + b v`` for a, b in [-1, 1]; ``u`` and ``v`` are perpendicular half edges, normal ``u x v``."""

    center: Vector
    u: Vector
    v: Vector

    @model_validator(mode="after")
    def _has_an_area(self) -> Rectangle:
        _refuse_zero(self.u, "u")
        _refuse_zero(self.v, "v")
        _refuse_slant(self.u, self.v)
        return self


class Disc(Part):
    center: Vector
    normal: Vector
    radius: Positive

    @model_validator(mode="after")
    def _has_a_direction(self) -> Disc:
        _refuse_zero(self.normal, "normal")
        return self


class Box(Part):
    min: Vector
    max: Vector

    @model_validator(mode="after")
    def _has_a_volume(self) -> Box:
        for axis, low, high in zip("xyz", self.min, self.max, strict=True):
            if not low < high:
                raise ValueError(f"min.{axis} = {low:g} is not below max.{axis} = {high:g}; exchange or move them")
        return self


class Cylinder(Part):
    """Closed by its two end discs."""

    from_: Vector = Field(alias="from")
    to: Vector
    radius: Positive

    @model_validator(mode="after")
    def _has_a_length(self) -> Cylinder:
        _refuse_same(self.from_, self.to)
        return self


class Cone(Part):
    """A closed frustum; one of the radii may be 0."""

    from_: Vector = Field(alias="from")
    to: Vector
    radius_from: NotNegative
    radius_to: NotNegative

    @model_validator(mode="after")
    def _has_a_volume(self) -> Cone:
        _refuse_same(self.from_, self.to)
        if self.radius_from == self.radius_to:
            raise ValueError("radius_from and radius_to are equal; use `cylinder`")
        return self


class Prism(Part):
    """A polygon in x, y extruded along z, centred on z = 0.

    It is given by ``profile`` and ``height``, or by ``apex_deg``, ``side`` and ``height``.

    With ``apex_deg`` the cross-section is isosceles: two sides of length ``side`` meet at the apex, which points to +y;
    the centroid is the origin.
    """

    height: Positive
    profile: tuple[tuple[Finite, Finite], ...] | None = None
    apex_deg: Annotated[float, Field(gt=0, lt=180, strict=True)] | None = None
    side: Positive | None = None

    @model_validator(mode="after")
    def _has_a_cross_section(self) -> Prism:
        by_apex = self.apex_deg is not None and self.side is not None
        if (self.profile is not None) == by_apex or (self.apex_deg is None) != (self.side is None):
            raise ValueError(
                "a prism needs one cross-section; give `profile` (corners [x, y]), or `apex_deg` and `side`"
            )
        if self.profile is not None and len(self.profile) < 3:
            raise ValueError("a profile needs at least three corners; add some")
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
        assert self.apex_deg is not None and self.side is not None
        half = math.radians(self.apex_deg) / 2
        base, rise = self.side * math.sin(half), self.side * math.cos(half)
        return ((-base, -rise / 3), (base, -rise / 3), (0.0, 2 * rise / 3))


class Lens(Part):
    """Two spherical faces about the z axis, centred on the origin; positive radii are convex, 0 is flat.

    The front face has its vertex at z = -thickness / 2 (light along +z meets it first), the back face at +z.

    ``thickness`` is at the axis, ``diameter`` that of the cylindrical rim.
    """

    radius_front: Finite
    radius_back: Finite
    thickness: Positive
    diameter: Positive


class Mesh(Part):
    """Triangles from a PLY or OBJ file beside the scene; closed and outward if the material transmits."""

    file: str
    smooth: Annotated[bool, Field(strict=True)] = True
    _moved_m: float = PrivateAttr(default=0.0)  # outwards, by a translation; no matter of a scene file; see mesh_of


Shape = Sphere | Plane | Rectangle | Disc | Box | Cylinder | Cone | Prism | Lens | Mesh
SHAPE_KEYS = ("sphere", "plane", "rectangle", "disc", "box", "cylinder", "cone", "prism", "lens", "mesh")


class Object(Part):
    """One named shape with its material; rotated about the origin by x, then y, then z, and then moved."""

    name: str
    material: str
    sphere: Sphere | None = None
    plane: Plane | None = None
    rectangle: Rectangle | None = None
    disc: Disc | None = None
    box: Box | None = None
    cylinder: Cylinder | None = None
    cone: Cone | None = None
    prism: Prism | None = None
    lens: Lens | None = None
    mesh: Mesh | None = None
    rotate_deg: Vector = (0.0, 0.0, 0.0)
    translate: Vector = (0.0, 0.0, 0.0)
    priority: Annotated[int, Field(ge=0, le=1000, strict=True)] | None = None

    @model_validator(mode="after")
    def _has_one_shape(self) -> Object:
        given = [key for key in SHAPE_KEYS if getattr(self, key) is not None]
        if len(given) != 1:
            found = " and ".join(given) if given else "none"
            raise ValueError(
                f"an object has exactly one shape, this one has {found}; the shapes are {', '.join(SHAPE_KEYS)}"
            )
        return self

    @property
    def shape(self) -> Shape:
        return next(value for key in SHAPE_KEYS if (value := getattr(self, key)) is not None)

    @property
    def shape_key(self) -> str:
        return next(key for key in SHAPE_KEYS if getattr(self, key) is not None)


# --- lights ---------------------------------------------------------------------------------------------------------


class Directional(Part):
    """Light from infinity; ``irradiance`` is that of a facing surface, W/m2."""

    direction: Vector
    irradiance: Colour
    angular_diameter_deg: Annotated[float, Field(ge=0, lt=90, strict=True)] = 0.0

    @model_validator(mode="after")
    def _has_a_direction(self) -> Directional:
        _refuse_zero(self.direction, "direction")
        return self


class Point(Part):
    """``intensity`` in W/sr; irradiance falls with the square of the distance."""

    position: Vector
    intensity: Colour


class Spot(Part):
    """A point light limited to a cone of full angle ``cone_deg``, with a sharp edge."""

    position: Vector
    direction: Vector
    intensity: Colour
    cone_deg: Annotated[float, Field(gt=0, lt=180, strict=True)]

    @model_validator(mode="after")
    def _has_a_direction(self) -> Spot:
        _refuse_zero(self.direction, "direction")
        return self


class Area(Part):
    """A one-sided Lambertian emitter of ``radiance``, or with ``collimated`` the lamp of figure 4.

    The collimated lamp sends all its light along the normal and takes ``irradiance``.
    """

    rectangle: Rectangle | None = None
    disc: Disc | None = None
    radiance: Colour | None = None
    collimated: Annotated[bool, Field(strict=True)] = False
    irradiance: Colour | None = None

    @model_validator(mode="after")
    def _is_complete(self) -> Area:
        if (self.rectangle is None) == (self.disc is None):
            raise ValueError("an area light has exactly one shape, `rectangle` or `disc`")
        if self.collimated and (self.irradiance is None or self.radiance is not None):
            raise ValueError("a collimated area light takes `irradiance` (W/m2), not `radiance`")
        if not self.collimated and (self.radiance is None or self.irradiance is not None):
            raise ValueError("an area light takes `radiance`; `irradiance` goes with `collimated: true`")
        return self


class Environment(Part):
    """Constant radiance from everywhere, or a lat-long EXR image."""

    radiance: Colour | None = None
    file: str | None = None

    @model_validator(mode="after")
    def _has_a_source(self) -> Environment:
        if (self.radiance is None) == (self.file is None):
            raise ValueError("an environment has exactly one source, `radiance` or `file`")
        return self


LIGHT_KEYS = ("directional", "point", "spot", "area", "environment")


class Light(Part):
    name: str
    directional: Directional | None = None
    point: Point | None = None
    spot: Spot | None = None
    area: Area | None = None
    environment: Environment | None = None

    @model_validator(mode="after")
    def _has_one_kind(self) -> Light:
        given = [key for key in LIGHT_KEYS if getattr(self, key) is not None]
        if len(given) != 1:
            found = " and ".join(given) if given else "none"
            raise ValueError(
                f"a light has exactly one kind, this one has {found}; the kinds are {', '.join(LIGHT_KEYS)}"
            )
        return self

    @property
    def emitter(self) -> Directional | Point | Spot | Area | Environment:
        return next(value for key in LIGHT_KEYS if (value := getattr(self, key)) is not None)

    @property
    def kind(self) -> str:
        return next(key for key in LIGHT_KEYS if getattr(self, key) is not None)


# --- camera, image, transport, observations -------------------------------------------------------------------------


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
        forward = _difference(self.look_at, self.position)
        if _length(forward) == 0:
            raise ValueError("the camera looks at its own position; move `look_at` or `position`")
        if self.kind == "perspective" and (self.fov_deg is None or self.height is not None):
            raise ValueError("a perspective camera takes `fov_deg`; `height` goes with `kind: orthographic`")
        if self.kind == "orthographic" and (self.height is None or self.fov_deg is not None):
            raise ValueError("an orthographic camera takes `height`; `fov_deg` goes with a perspective camera")
        if _length(_cross(forward, self.up)) <= 1e-12 * _length(forward) * _length(self.up):
            raise ValueError("`up` is along the view direction; choose another, for example `up: [0, 0, 1]`")
        return self


class Image(Part):
    width: Annotated[int, Field(ge=1, le=16384, strict=True)]
    height: Annotated[int, Field(ge=1, le=16384, strict=True)]
    exposure_stops: Finite = 0.0
    samples: Annotated[int, Field(ge=1, le=65536, strict=True)] | None = None


class Ambient(Part):
    """Constant irradiance on every diffuse surface, the stand-in for indirect light that the paper names."""

    ambient: Colour


class SpectralBands(Part):
    spectral: Annotated[int, Field(ge=2, le=256, strict=True)]


class Transport(Part):
    """What light may do on its way, where a scene wants more or less than the defaults."""

    indirect: Literal["none", "photons"] | Ambient = "none"
    max_reflections: Annotated[int, Field(ge=0, le=1000, strict=True)] = 8
    max_transmissions: Annotated[int, Field(ge=0, le=1000, strict=True)] = 64
    bands: Literal["paper", "povray", "continuous"] | SpectralBands = "paper"


class Paper(Part):
    """Literal readings of the paper that ``docs/sources.md`` calls wrong, each switched on by name."""

    tir: Literal["reflect", "drop"] = "reflect"
    refraction: Literal["corrected", "literal"] = "corrected"
    literal_sum: Annotated[bool, Field(strict=True)] = False
    dispersion: Literal["step", "span"] = "step"
    dispersion_reference: Literal["red", "d_line", "middle"] = "red"
    disperse_camera: Annotated[bool, Field(strict=True)] = True
    rough_samples: Annotated[int, Field(ge=1, le=256, strict=True)] = 1
    count_transmission: Annotated[bool, Field(strict=True)] = False
    shadow: Literal["opaque", "filter"] = "opaque"
    rough_photons: Literal["reciprocal", "literal"] = "reciprocal"


class Patch(Part):
    """A rectangle on a receiver: ``center + a u + b v`` for a, b in [-1, 1], metres."""

    center: Vector
    u: Vector
    v: Vector

    @model_validator(mode="after")
    def _has_an_area(self) -> Patch:
        _refuse_zero(self.u, "u")
        _refuse_zero(self.v, "v")
        _refuse_slant(self.u, self.v)
        return self


class Observation(Part):
    """One phenomenon, measured on one patch."""

    name: str
    phenomenon: Phenomenon
    patch: Patch
    along: Literal["u", "v"] | None = None
    pattern: str | None = None


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


# --- small vector checks --------------------------------------------------------------------------------------------


def _difference(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _length(a: Vector) -> float:
    return math.hypot(*a)


def _refuse_zero(vector: Vector, key: str) -> None:
    if _length(vector) == 0:
        raise ValueError(f"`{key}` is the zero vector and has no direction; give it a length")


def _refuse_same(a: Vector, b: Vector) -> None:
    if a == b:
        raise ValueError("`from` and `to` are the same point; move one of them")


def _refuse_slant(u: Vector, v: Vector) -> None:
    cosine = sum(a * b for a, b in zip(u, v, strict=True)) / (_length(u) * _length(v))
    if abs(cosine) > 1e-9:
        raise ValueError(f"`u` and `v` are not perpendicular (cosine {cosine:.3g}); turn one of them")
