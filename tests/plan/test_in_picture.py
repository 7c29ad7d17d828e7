"""The view never denies what is in the picture, and denies what is plainly outside."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from vitrail.geometry.bounds import Bounds
from vitrail.geometry.camera import View
from vitrail.plan.in_picture import may_see_box, plane_hits, sees_plane
from vitrail.scene.model import Camera, Image, Plane

coordinate = st.floats(-5, 5).map(lambda value: round(value, 3))
point = st.tuples(coordinate, coordinate, coordinate)
IMAGE = Image(width=64, height=48)


def cameras() -> st.SearchStrategy[Camera]:
    def build(position: tuple, target: tuple, perspective: bool) -> Camera | None:
        kind = {"fov_deg": 50.0} if perspective else {"kind": "orthographic", "height": 3.0}
        try:
            return Camera.model_validate({"position": position, "look_at": target, "up": (0.1, 1, 0.2), **kind})
        except ValueError:
            return None

    return st.builds(build, point, point, st.booleans()).filter(lambda camera: camera is not None)  # type: ignore


@pytest.mark.slow
@settings(max_examples=300, deadline=None)
@given(camera=cameras(), corner=point, size=st.tuples(*[st.floats(0.01, 3)] * 3), seed=st.integers(0, 1000))
def test_a_box_with_a_point_in_the_picture_may_be_seen(camera: Camera, corner: tuple, size: tuple, seed: int) -> None:
    bounds = Bounds(corner, tuple(np.add(corner, size)))
    points = np.random.default_rng(seed).uniform(bounds.low, bounds.high, (200, 3))
    x, y, depth = View.of(camera, IMAGE).project(points)
    seen = (depth > 0) & (x >= 0) & (x <= 64) & (y >= 0) & (y <= 48)
    assert may_see_box(View.of(camera, IMAGE), bounds) or not seen.any()


@pytest.mark.slow
@settings(max_examples=300, deadline=None)
@given(camera=cameras(), place=point, normal=point.filter(lambda n: np.linalg.norm(n) > 0.1))
@example(
    Camera(position=(3, 1, 0), look_at=(0, 0, 0), up=(0.1, 1, 0.2), kind="orthographic", height=3), (3, 1, 0), (3, 1, 0)
)
def test_a_plane_is_seen_when_and_only_when_a_ray_of_the_picture_meets_it(
    camera: Camera, place: tuple, normal: tuple
) -> None:
    view, n = View.of(camera, IMAGE), np.array(normal) / np.linalg.norm(normal)
    steps = np.linspace(-1, 1, 21)
    met = False
    for sx in steps:
        for sy in steps:
            origin, direction = view.ray(sx, sy)
            distance, approach = np.dot(n, np.subtract(origin, place)), np.dot(n, direction)
            met |= bool(distance * approach < -1e-12)
    assert sees_plane(view, Plane(point=place, normal=normal)) or not met
    # The corner rays are among the sampled ones, so both agree but for planes that touch the picture in one corner, or
    # that hold the eye of a corner ray: rounding decides those.
    if not met and plane_hits(view, Plane(point=place, normal=normal)):
        corners = [view.ray(x, y) for x in (-1, 1) for y in (-1, 1)]
        away = [abs(np.dot(n, np.subtract(origin, place))) for origin, _ in corners]
        assert min(*away, *(abs(np.dot(n, direction)) for _, direction in corners)) < 1e-9


@pytest.mark.parametrize(
    ("low", "high", "seen"),
    [
        ((-1, -1, -6), (1, 1, -5), True),
        ((-1, -1, 5), (1, 1, 6), False),  # behind the camera
        ((20, -1, -6), (21, 1, -5), False),  # to the right
        ((-1, 20, -6), (1, 21, -5), False),  # above
        ((-9, -9, -9), (9, 9, 9), True),  # around the camera
    ],
)
def test_boxes_before_beside_and_behind_a_camera(low: tuple, high: tuple, seen: bool) -> None:
    camera = Camera.model_validate({"position": (0, 0, 0), "look_at": (0, 0, -1), "fov_deg": 60})
    assert may_see_box(View.of(camera, IMAGE), Bounds(low, high)) is seen
