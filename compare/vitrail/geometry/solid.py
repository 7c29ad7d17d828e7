"""What every shape that stands in the world can be asked. ``shapes/`` has one file for each family of shapes.

Lengths are metres, points world coordinates; arrays of points are (n, 3). A shape that lacks an answer cannot be made:
mypy names it in ``placement.solid_of``.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from pydantic import ValidationError

from vitrail.base.changed import changed
from vitrail.base.fault import Fault
from vitrail.base.vector import Vec
from vitrail.geometry.bounds import Bounds
from vitrail.geometry.face import Face
from vitrail.geometry.frame import Frame
from vitrail.geometry.surface import SurfaceFrame
from vitrail.scene.model import Plane, Shape

Ball = tuple[np.ndarray, float]
"""Center and radius of a sphere."""


@dataclass(frozen=True, eq=False)
class Solid(ABC):
    """A shape in the world; a plane fills the half space below its normal, rectangle and disc enclose nothing.

    ``frame`` is the identity for shapes that are described by points and directions, whose numbers are those of the
    world; the others (box, prism, lens, mesh) keep their own axes and carry the frame.
    """

    shape: Shape
    frame: Frame

    @abstractmethod
    def moved(self, frame: Frame) -> Self:
        """The solid where a frame puts it; it must stand in its own axes, that is in the identity frame.

        Normals and half edges keep their lengths to rounding.
        """

    @abstractmethod
    def grown(self, by_m: float) -> Self | None:
        """The solid with its surface moved outwards, below 0 inwards; None for what is infinite or flat,
        and where nothing would be left.
        """

    def _with(self, **sizes: object) -> Self | None:
        """The solid with other sizes; None where its shape cannot have them, as when nothing is left of it."""
        try:
            return replace(self, shape=changed(self.shape, **sizes))
        except ValidationError:
            return None

    @property
    @abstractmethod
    def bounds(self) -> Bounds:
        """The room it takes."""

    @property
    @abstractmethod
    def ball(self) -> Ball | None:
        """A sphere around it, where an overlap is searched for; None for half spaces, flat shapes and meshes."""

    @abstractmethod
    def depth(self, points: np.ndarray) -> np.ndarray:
        """Depth (n,) of points: positive inside, negative outside, zero on the surface; -inf without an inside.

        The sign is exact for every shape; the size never exceeds the distance to the surface.
        """

    @abstractmethod
    def surface_points(self, towards: Solid) -> list[Vec]:
        """Points on its surface at which a touch shows: corners, edges, rims, and the near side of a ball."""

    @abstractmethod
    def directions_from(self, point: Vec) -> list[Vec]:
        """Directions in which it may be nearest to a point: its normals, or its middle; of any length."""

    @property
    @abstractmethod
    def thickness_m(self) -> float:
        """The smallest thickness; infinite for what is flat or open."""

    @property
    @abstractmethod
    def faces(self) -> list[Face]:
        """The surfaces around it; none for a mesh and for what is no solid."""

    @property
    @abstractmethod
    def is_convex_or_flat(self) -> bool:
        """Whether no straight line leaves it and meets it again."""

    @property
    @abstractmethod
    def curvature_radius_m(self) -> float | None:
        """The smallest radius of curvature; None for flat faces, and for meshes, where it is not known."""

    # --- what follows from these, and what few shapes answer ---------------------------------------------------------

    @property
    def is_closed(self) -> bool:
        """Whether it encloses something: all but rectangle and disc."""
        return True

    @property
    def carrier(self) -> Plane | None:
        """The plane in which a flat shape lies; None for a body."""
        return None

    @property
    def surface_frame(self) -> SurfaceFrame | None:
        """Where a pattern lies on it; None unless it is flat."""
        return None

    @property
    def number_size_m(self) -> float:
        """The size of the numbers that describe it, for tolerances."""
        ball = self.ball
        return 0.0 if ball is None else float(np.linalg.norm(ball[0])) + ball[1]

    def faults(self) -> Iterator[Fault]:
        """Numbers that are legal one by one and describe nothing together, each with the keys that lead to it."""
        yield from ()

    def is_inside(self, points: np.ndarray) -> np.ndarray:
        """Which (n,) of the points lie strictly inside."""
        return self.depth(points) > 0

    def contains(self, point: Vec) -> bool:
        return bool(self.is_inside(np.array([point], float))[0])

    def distances(self, points: Sequence[Vec]) -> list[float]:
        """Distance of each point: zero on the surface, elsewhere at most the true one; infinite where not known."""
        return [abs(float(self.depth(np.array([point], float))[0])) for point in points]

    def distance(self, point: Vec) -> float:
        return self.distances([point])[0]
