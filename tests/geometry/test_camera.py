"""The camera: known points of the world fall on known pixels."""

import numpy as np
import pytest

from vitrail.geometry.camera import View
from vitrail.scene.model import Camera, Image

IMAGE = Image(width=200, height=100)
PERSPECTIVE = Camera(position=(0.0, 0.0, 5.0), look_at=(0.0, 0.0, 0.0), fov_deg=60.0)
ORTHOGRAPHIC = Camera(kind="orthographic", position=(1.0, 0.0, 5.0), look_at=(1.0, 0.0, 0.0), height=4.0)


def test_axes_are_right_handed():
    view = View.of(PERSPECTIVE, IMAGE)
    np.testing.assert_allclose(view.forward, [0, 0, -1], atol=1e-15)
    np.testing.assert_allclose(view.right, [1, 0, 0], atol=1e-15)
    np.testing.assert_allclose(view.up, [0, 1, 0], atol=1e-15)


def test_the_field_of_view_is_vertical():
    # The top of the picture at distance 5 is 5 tan 30 deg up; a picture twice as wide shows twice that to the right.
    top = 5 * np.tan(np.radians(30))
    x, y, depth = View.of(PERSPECTIVE, IMAGE).project(np.array([[0, top, 0], [2 * top, 0, 0], [0, 0, 0]]))
    np.testing.assert_allclose(x, [100, 200, 100], atol=1e-9)
    np.testing.assert_allclose(y, [0, 50, 50], atol=1e-9)
    np.testing.assert_allclose(depth, 5)


def test_an_orthographic_view_has_a_height_in_metres():
    x, y, _ = View.of(ORTHOGRAPHIC, IMAGE).project(np.array([[1, 2, 0], [5, 0, -30], [1, 0, 7]]))
    # A point behind the camera is still on its line of sight.
    np.testing.assert_allclose(x, [100, 200, 100], atol=1e-9)
    np.testing.assert_allclose(y, [0, 50, 50], atol=1e-9)


def test_behind_a_perspective_camera_there_is_no_pixel():
    x, y, depth = View.of(PERSPECTIVE, IMAGE).project(np.array([[0.0, 0.0, 9.0]]))
    assert depth[0] < 0 and np.isnan(x[0]) and np.isnan(y[0])


@pytest.mark.parametrize("camera", [PERSPECTIVE, ORTHOGRAPHIC])
def test_what_a_pixel_shows_falls_on_that_pixel(camera):
    view = View.of(camera, IMAGE)
    point = view.point_on_plane(31.5, 77.25, np.array([0.0, -3.0, 0.0]), np.array([0.1, 1.0, 0.3]))
    x, y, _ = view.project(point)
    assert (x, y) == pytest.approx((31.5, 77.25), abs=1e-9)


def test_a_pixel_grows_with_depth_for_perspective_and_not_for_orthographic_cameras():
    camera = Camera.model_validate({"position": (0, 0, 0), "look_at": (0, 0, -1), "fov_deg": 90})
    assert View.of(camera, Image(width=64, height=48)).pixel_size_m((5, 5, -3)) == pytest.approx(2 * 3 / 48)
    flat = Camera.model_validate({"kind": "orthographic", "position": (0, 0, 0), "look_at": (0, 0, -1), "height": 12})
    assert View.of(flat, Image(width=64, height=48)).pixel_size_m((5, 5, -3)) == pytest.approx(12 / 48)


@pytest.mark.parametrize("camera", [PERSPECTIVE, ORTHOGRAPHIC])
def test_one_point_is_sighted_where_many_are_projected(camera):
    view = View.of(camera, IMAGE)
    for point in ((0.3, -0.2, 1.0), (1.5, 0.7, -3.0)):
        seen, (x, y, depth) = view.sight(point), view.project(np.array(point))
        assert ((seen.x + 1) * 100, (1 - seen.y) * 50, seen.depth_m) == pytest.approx((x, y, depth), abs=1e-12)
        away = np.subtract(point, view.position)
        assert view.direction_to(point) == pytest.approx(away if view.perspective else [0, 0, point[2] - 5], abs=1e-12)
        assert view.sight_line(point) == pytest.approx(
            np.divide(view.direction_to(point), np.linalg.norm(view.direction_to(point))), abs=1e-12
        )
