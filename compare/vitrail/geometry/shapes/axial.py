"""Bodies of revolution about a line from one point to another: cylinder and cone, closed by their end discs."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from vitrail.base.changed import unchecked
from vitrail.base.vector import Vec, add, length, scale, subtract, unit
from vitrail.geometry.bounds import Bounds, about_disc, together
from vitrail.geometry.face import Face, flat_face, tube_face
from vitrail.geometry.frame import Frame
from vitrail.geometry.landmarks import rim
from vitrail.geometry.solid import Ball, Solid
from vitrail.geometry.surface import tangents
from vitrail.scene.model import Cone, Cylinder


class AxialSolid(Solid):
    """A frustum: what cylinder and cone answer alike."""

    shape: Cylinder | Cone

    @property
    @abstractmethod
    def radii(self) -> tuple[float, float]:
        """The radii at ``from`` and at ``to``."""

    @property
    def axis(self) -> Vec:
        """From end to end, metres."""
        return subtract(self.shape.to, self.shape.from_)

    @property
    def bounds(self) -> Bounds:
        first, last = self.radii
        ends = (about_disc(self.shape.from_, self.axis, first), about_disc(self.shape.to, self.axis, last))
        return together(ends)

    @property
    def ball(self) -> Ball:
        half = np.linalg.norm(np.subtract(self.shape.to, self.shape.from_)) / 2
        return np.add(self.shape.from_, self.shape.to) / 2, float(np.hypot(half, max(self.radii)))

    def depth(self, points: np.ndarray) -> np.ndarray:
        """The nearest of the two discs and the mantle."""
        points, start, (first, last) = np.asarray(points, float), self.shape.from_, self.radii
        axis = np.subtract(self.shape.to, start)
        size = np.linalg.norm(axis)
        axis = axis / size
        along = (points - start) @ axis
        aside = np.linalg.norm(points - start - np.outer(along, axis), axis=1)
        slope = (last - first) / size
        mantle = (first + slope * along - aside) / np.hypot(1, slope)
        return np.minimum(np.minimum(along, size - along), mantle)

    def surface_points(self, towards: Solid) -> list[Vec]:
        first, last = self.radii
        return [*rim(self.shape.from_, self.axis, first), *rim(self.shape.to, self.axis, last)]

    def directions_from(self, point: Vec) -> list[Vec]:
        u, v = tangents(self.axis)
        return [self.axis, scale(self.axis, -1), u, v, scale(u, -1), scale(v, -1)]

    @property
    def thickness_m(self) -> float:
        return min(2 * max(self.radii), length(self.axis))

    @property
    def faces(self) -> list[Face]:
        axis = unit(self.axis)
        return [flat_face(scale(axis, -1), self.shape.from_), flat_face(axis, self.shape.to), self._mantle(axis)]

    @abstractmethod
    def _mantle(self, axis: Vec) -> Face:
        """The side, about an axis of unit length."""

    @property
    def is_convex_or_flat(self) -> bool:
        return True

    @property
    def curvature_radius_m(self) -> float:
        return max(self.radii)


@dataclass(frozen=True, eq=False)
class PlacedCylinder(AxialSolid):
    """A cylinder with its ends in the world."""

    shape: Cylinder

    @property
    def radii(self) -> tuple[float, float]:
        return self.shape.radius, self.shape.radius

    def moved(self, frame: Frame) -> PlacedCylinder:
        ends = {"from_": frame.point(self.shape.from_), "to": frame.point(self.shape.to)}
        return PlacedCylinder(unchecked(self.shape, **ends), Frame())

    def grown(self, by_m: float) -> PlacedCylinder | None:
        outward = scale(unit(self.axis), by_m)
        ends = {"from_": subtract(self.shape.from_, outward), "to": add(self.shape.to, outward)}
        return self._with(**ends, radius=self.shape.radius + by_m)

    def _mantle(self, axis: Vec) -> Face:
        return tube_face(axis, self.shape.from_, self.shape.radius)


@dataclass(frozen=True, eq=False)
class PlacedCone(AxialSolid):
    """A frustum with its ends in the world."""

    shape: Cone

    @property
    def radii(self) -> tuple[float, float]:
        return self.shape.radius_from, self.shape.radius_to

    def moved(self, frame: Frame) -> PlacedCone:
        ends = {"from_": frame.point(self.shape.from_), "to": frame.point(self.shape.to)}
        return PlacedCone(unchecked(self.shape, **ends), Frame())

    def grown(self, by_m: float) -> PlacedCone | None:
        """Scaled about its middle until it is thicker by that much on both sides."""
        factor, middle = 1 + 2 * by_m / self.thickness_m, scale(add(self.shape.from_, self.shape.to), 0.5)

        def scaled(point: Vec) -> Vec:
            return add(middle, scale(subtract(point, middle), factor))

        first, last = self.radii
        ends = {"from_": scaled(self.shape.from_), "to": scaled(self.shape.to)}
        return self._with(**ends, radius_from=first * factor, radius_to=last * factor)

    def _mantle(self, axis: Vec) -> Face:
        """By its tip and its slope, along the direction in which it widens."""
        first, last = self.radii
        slope = (last - first) / length(self.axis)
        tip = subtract(self.shape.from_, scale(axis, first / slope))
        return Face("cone", axis if slope > 0 else scale(axis, -1), tip, abs(slope))
