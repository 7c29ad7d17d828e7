"""What a mesh encloses: whether it is a solid at all, which points are inside, and how far away its surface is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from vitrail.base.fault import Fault
from vitrail.geometry.mesh_file import Triangles
from vitrail.geometry.mesh_shadow import Shadow

SAMPLED = 256
"""Faces of a mesh that are asked, evenly over the file: where a solid turns inside out, whole rows of faces do."""
HAIR = 1e-6
"""Share of its size by which a point stands off a face, to be on one side of it."""
TOLD_APART = 0.02
"""Least share of the largest eigenvalue: faces that bend by less than some 16 degrees count as one smooth surface."""
CLOSE = "close the mesh with outward triangles, or take an opaque material"
JOIN = "join its parts into one without inner faces, or make an object of each"
_AT_ONCE = 1 << 18


@dataclass(frozen=True, eq=False)
class MeshSolid:
    """Triangles in the world with what is asked of them; points are (n, 3), metres."""

    triangles: Triangles

    @cached_property
    def corners(self) -> np.ndarray:
        """Corners of the faces that have an area, (m, 3, 3)."""
        corners = self.triangles.corners
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        return corners[area > 0]

    @cached_property
    def normals(self) -> np.ndarray:
        """Outward unit normals of those faces, (m, 3)."""
        area = np.cross(self.corners[:, 1] - self.corners[:, 0], self.corners[:, 2] - self.corners[:, 0])
        return area / np.linalg.norm(area, axis=1, keepdims=True)

    @cached_property
    def middles(self) -> np.ndarray:
        return self.corners.mean(axis=1)

    @cached_property
    def size(self) -> float:
        """The diagonal of the box around it, metres."""
        vertices = self.triangles.vertices
        return float(np.linalg.norm(vertices.max(axis=0) - vertices.min(axis=0)))

    @cached_property
    def sample(self) -> np.ndarray:
        """Indices of faces evenly over the file, at most ``SAMPLED``."""
        return np.unique(np.linspace(0, len(self.corners) - 1, SAMPLED).astype(int))

    @cached_property
    def _tree(self) -> cKDTree:
        return cKDTree(self.middles)

    @cached_property
    def _reach(self) -> float:
        """The farthest that a corner is from the middle of its face."""
        return float(np.linalg.norm(self.corners - self.middles[:, None], axis=2).max())

    @cached_property
    def _shadow(self) -> Shadow:
        return Shadow.of(self.corners)

    def winding(self, points: np.ndarray) -> np.ndarray:
        """How often the mesh encloses each point (n,): 1 inside a solid, 0 outside, below 0 where it is inside out."""
        return self._shadow.winding(np.asarray(points, float))

    def distance(self, points: np.ndarray) -> np.ndarray:
        """Distance (n,) of points from the surface."""
        points = np.asarray(points, float)
        found, _ = self._tree.query(points)
        near = self._tree.query_ball_point(points, found + self._reach)
        count = np.array([len(each) for each in near])
        for start, end in _chunks(count):
            which = np.repeat(np.arange(start, end), count[start:end])
            faces = np.concatenate([np.asarray(each, int) for each in near[start:end]])
            away = _from_triangles(points[which], self.corners[faces], self.normals[faces])
            np.minimum.at(found, which, away)
        return found

    def depth(self, points: np.ndarray) -> np.ndarray:
        """Depth (n,) of points inside, negative outside."""
        return np.where(self.winding(points) > 0, 1.0, -1.0) * self.distance(points)

    def inner_points(self) -> np.ndarray:
        """Points in its inside, a hair behind its faces."""
        return self.middles[self.sample] - HAIR * self.size * self.normals[self.sample]

    def surface_points(self) -> np.ndarray:
        """Corners and middles of faces, evenly over the file."""
        return np.concatenate([np.unique(self.corners[self.sample].reshape(-1, 3), axis=0), self.middles[self.sample]])

    def thickness(self) -> float:
        """The least way through the solid that starts square to one of the sampled faces, metres."""
        ways = [self._way_through(self.middles[face], -self.normals[face]) for face in self.sample]
        return min(ways)

    def _way_through(self, start: np.ndarray, way: np.ndarray) -> float:
        """How far a line that starts on a face goes until it meets the solid from its inside."""
        a, first, second = self.corners[:, 0], *(self.corners[:, k] - self.corners[:, 0] for k in (1, 2))
        across = np.cross(way, second)
        turn = (first * across).sum(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            u = ((start - a) * across).sum(axis=1) / turn
            aside = np.cross(start - a, first)
            v, far = aside @ way / turn, (aside * second).sum(axis=1) / turn
            meets = (u >= 0) & (v >= 0) & (u + v <= 1) & (far > HAIR * self.size) & (self.normals @ way > 0)
        return float(far[meets].min()) if meets.any() else np.inf

    def moved(self, outwards_m: float) -> Triangles:
        """The mesh with every face moved along its normal, as far as its edges allow; corners keep their shape."""
        vertices = self.triangles.vertices
        first, same = _merged(vertices)
        # Ask each vertex for the step that moves all its faces alike: sum(n n') step = sum(n).
        corners = self.triangles.corners
        area = _areas(corners)
        length = np.linalg.norm(area, axis=1, keepdims=True)
        normals = np.divide(area, length, out=np.zeros_like(area), where=length > 0)
        outer, total = np.zeros((len(first), 3, 3)), np.zeros((len(first), 3))
        for k in range(3):
            at = same[self.triangles.faces[:, k]]
            np.add.at(outer, at, normals[:, :, None] * normals[:, None, :])
            np.add.at(total, at, normals)
        # Leave out directions that the faces around a vertex hardly tell apart.
        strength, ways = np.linalg.eigh(outer)
        told = strength > TOLD_APART * strength[:, -1:]
        along = np.divide(np.einsum("vik,vi->vk", ways, total), strength, out=np.zeros_like(total), where=told)
        steps = np.einsum("vik,vk->vi", ways, along)[same]
        return Triangles(vertices + outwards_m * steps, self.triangles.faces, self.triangles.normals)


def fault_of_solid(mesh: MeshSolid) -> Fault | None:
    """Why a mesh encloses nothing that glass could fill; None for a closed surface that faces outwards everywhere."""
    if len(mesh.corners) == 0:
        return Fault("has no triangle with an area", CLOSE)
    if (hole := _hole(mesh)) is not None:
        return hole
    if np.einsum("mi,mi->", mesh.corners[:, 0] - mesh.corners[0, 0], _areas(mesh.corners)) <= 0:
        return Fault("is inside out", CLOSE)
    return _crossing(mesh)


def _crossing(mesh: MeshSolid) -> Fault | None:
    """Outside every face there must be nothing: no wall that faces inwards, and no other part of the same mesh."""
    asked = np.union1d(mesh.sample, _a_face_of_each_part(mesh))
    first, second = (
        mesh.winding(mesh.middles[asked] + hair * mesh.size * mesh.normals[asked]) for hair in (HAIR, HAIR * 1e-3)
    )
    turned, inside = first < 0, (first > 0) & (second > 0)
    for wrong, what in ((turned, "crosses itself and is inside out"), (inside, "has a part inside another")):
        if wrong.any():
            place = _place(mesh.middles[asked[wrong.argmax()]])
            return Fault(f"{what} at {place}", CLOSE if wrong is turned else JOIN)
    return None


def _a_face_of_each_part(mesh: MeshSolid) -> np.ndarray:
    """Parts are faces that hang together by their corners."""
    _, vertex = _merged(mesh.corners.reshape(-1, 3))
    faces = vertex.reshape(-1, 3)
    pairs = np.concatenate([faces[:, :2], faces[:, 1:]])
    graph = coo_matrix((np.ones(len(pairs), bool), pairs.T), shape=(vertex.max() + 1,) * 2)
    part = connected_components(graph, directed=False)[1][faces[:, 0]]
    return np.unique(part, return_index=True)[1]


def _place(point: np.ndarray) -> str:
    return "[" + ", ".join(f"{each:.4g}" for each in point) + "]"


def _hole(mesh: MeshSolid) -> Fault | None:
    """Every edge must be there once in each direction; vertices at one position are one."""
    first, vertex = _merged(mesh.triangles.vertices)
    faces = vertex[mesh.triangles.faces]
    faces = faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])]
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    # Sort the edges as numbers: at a million triangles a set of them takes ten times as long.
    there, back = np.sort(edges[:, 0] * len(first) + edges[:, 1]), np.sort(edges[:, 1] * len(first) + edges[:, 0])
    twice = there[1:] == there[:-1]
    if twice.any() and np.array_equal(there, back):
        ends = np.array(divmod(there[twice.argmax()], len(first)))
        place = _place(mesh.triangles.vertices[first[ends]].mean(axis=0))
        return Fault(f"has two parts that touch along an edge at {place}", JOIN)
    if twice.any():
        return Fault("has an edge with two triangles on the same side", CLOSE)
    return None if np.array_equal(there, back) else Fault("has a hole", CLOSE)


def _merged(vertices: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The first vertex (k,) at each position, in the order of positions, and the position (n,) of each vertex."""
    order = np.lexsort(vertices.T[::-1])
    ordered = vertices[order]
    is_new = np.ones(len(vertices), bool)
    is_new[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    same = np.empty(len(vertices), int)
    same[order] = np.cumsum(is_new) - 1
    return order[is_new], same


def _areas(corners: np.ndarray) -> np.ndarray:
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def _chunks(count: np.ndarray) -> Iterator[tuple[int, int]]:
    """Ranges of points that have some ``_AT_ONCE`` candidates together."""
    start = 0
    while start < len(count):
        end = start + max(1, int(np.searchsorted(np.cumsum(count[start:]), _AT_ONCE)))
        yield start, end
        start = end


def _from_triangles(points: np.ndarray, corners: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Distance (n,) of each point from its triangle: from the plane where it is above it, else from the edges."""
    found, above = np.full(len(points), np.inf), np.ones(len(points), bool)
    for k in range(3):
        edge, away = corners[:, (k + 1) % 3] - corners[:, k], points - corners[:, k]
        along = np.clip((away * edge).sum(axis=1) / (edge * edge).sum(axis=1), 0, 1)
        found = np.minimum(found, np.linalg.norm(away - along[:, None] * edge, axis=1))
        above &= (np.cross(edge, away) * normals).sum(axis=1) >= 0
    height = np.abs(((points - corners[:, 0]) * normals).sum(axis=1))
    return np.where(above, height, found)
