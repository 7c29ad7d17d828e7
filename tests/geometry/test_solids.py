"""What every shape answers must fit together: its points, depth, room, growth and faces are those of one body."""

from __future__ import annotations

import numpy as np
import pytest

from vitrail.geometry.frame import frame_of
from vitrail.geometry.placement import place, solid_of
from vitrail.geometry.solid import Solid
from vitrail.scene.model import Object

TURNS = ([0, 0, 0], [90, 0, 0], [20, -35, 70])
CLOSED = {
    "sphere": {"center": [0.2, 0.1, -0.3], "radius": 0.7},
    "box": {"min": [-0.5, -0.2, -0.9], "max": [0.6, 0.3, 0.1]},
    "cylinder": {"from": [0, -0.5, 0], "to": [0.3, 0.5, 0.2], "radius": 0.4},
    "cone": {"from": [0, 0, 0], "to": [0.5, 0.5, 0], "radius_from": 0.6, "radius_to": 0.1},
    "prism": {"apex_deg": 60, "side": 1, "height": 1.5},
    "lens": {"radius_front": 1.2, "radius_back": 0, "thickness": 0.5, "diameter": 1},
}
FLAT = {
    "rectangle": {"center": [0.1, 0.2, 0.3], "u": [0.4, 0.1, 0], "v": [0, 0, 0.3]},
    "disc": {"center": [0.1, 0.2, 0.3], "normal": [1, 2, 3], "radius": 0.5},
}
ROUNDING = 1e-14
"""Some ten operations on numbers near 1."""


def item(kind: str, turn: list[float]) -> Object:
    shape = {**CLOSED, **FLAT}[kind]
    return Object.model_validate(
        {"name": "it", "material": "m", kind: shape, "rotate_deg": turn, "translate": [0.3, -0.2, 0.4]}
    )


def solids(kinds: dict) -> list[Solid]:
    return [place(item(kind, turn)) for kind in kinds for turn in TURNS]


def on_the_surface(solid: Solid) -> np.ndarray:
    """The points of a surface, without those that stand for the middle of an end, a face or an axis inside it."""
    points = np.array(solid.surface_points(solid))
    return points[np.array(solid.distances([tuple(each) for each in points])) < 1e-9]


@pytest.mark.parametrize("solid", solids({**CLOSED, **FLAT}), ids=lambda solid: solid.shape.key)
def test_points_of_a_surface_lie_on_it_and_within_its_bounds(solid: Solid) -> None:
    points = np.array(solid.surface_points(solid))
    away = solid.distances([tuple(each) for each in points])
    if solid.shape.key == "lens":
        # The rim of a lens is drawn in its middle plane: on the cylinder if that is not cut away, else outside.
        away = away[:2]
    assert max(away) <= ROUNDING
    assert (points >= np.array(solid.bounds.low) - ROUNDING).all()
    assert (points <= np.array(solid.bounds.high) + ROUNDING).all()


@pytest.mark.parametrize("turn", TURNS)
@pytest.mark.parametrize("kind", CLOSED)
def test_a_body_is_as_deep_as_before_it_was_moved(kind: str, turn: list[float]) -> None:
    thing = item(kind, turn)
    points, frame = np.random.default_rng(2).uniform(-1, 1, (300, 3)), frame_of(thing)
    moved = np.array([frame.point(tuple(each)) for each in points])
    assert place(thing).depth(moved) == pytest.approx(solid_of(thing.shape).depth(points), abs=ROUNDING)


@pytest.mark.parametrize("solid", solids(CLOSED), ids=lambda solid: solid.shape.key)
def test_growing_moves_the_surface_outwards_and_back(solid: Solid) -> None:
    """What is scaled grows by that much where it is thinnest, and by more elsewhere."""
    larger = solid.grown(0.01)
    assert larger is not None
    assert larger.thickness_m == pytest.approx(solid.thickness_m + 0.02, rel=1e-12)
    assert (larger.depth(on_the_surface(solid)) > 0).all()
    back = larger.grown(-0.01)
    assert back is not None and back.thickness_m == pytest.approx(solid.thickness_m, rel=1e-12)
    points = np.random.default_rng(3).uniform(-1.2, 1.6, (300, 3))
    assert back.depth(points) == pytest.approx(solid.depth(points), abs=ROUNDING)


@pytest.mark.parametrize("solid", solids(CLOSED), ids=lambda solid: solid.shape.key)
def test_a_body_shares_its_faces_with_itself_and_none_with_a_larger_one(solid: Solid) -> None:
    larger = solid.grown(0.01)
    assert larger is not None and len(solid.faces) == len(larger.faces)
    for index, face in enumerate(solid.faces):
        assert [other for other, each in enumerate(solid.faces) if face.is_same(each)] == [index]
        assert not any(face.is_same(each) for each in larger.faces)


@pytest.mark.parametrize("solid", solids(FLAT), ids=lambda solid: solid.shape.key)
def test_a_flat_shape_lies_in_its_plane_and_has_no_inside(solid: Solid) -> None:
    frame, points = solid.surface_frame, solid.surface_points(solid)
    assert frame is not None and solid.carrier is not None and not solid.is_closed and solid.grown(1.0) is None
    for point in points:
        s, t = frame.coordinates(point)
        back = np.array(frame.origin) + s * np.array(frame.u) + t * np.array(frame.v)
        assert back == pytest.approx(point, abs=ROUNDING)
    assert np.isneginf(solid.depth(np.array(points))).all()
