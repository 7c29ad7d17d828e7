"""A patch must conserve flux and know its metres; aligned orthographic views must return pixels unchanged."""

import numpy as np
import pytest

from vitrail.geometry.camera import View
from vitrail.images.patch import make_grid, sample_patch
from vitrail.scene.model import Camera, Image, Patch


def above(height=2.0, center=(0.0, 0.0, 0.0), up=(0.0, 0.0, -1.0)):
    """An orthographic camera that looks straight down: x to the right, z towards the bottom of the image."""
    position = (center[0], 5.0, center[2])
    return Camera(kind="orthographic", position=position, look_at=center, up=up, height=height)


def floor_patch(half_u, half_v, center=(0.0, 0.0, 0.0)):
    return Patch(center=center, u=(half_u, 0.0, 0.0), v=(0.0, 0.0, half_v))


@pytest.fixture
def noise():
    return np.random.default_rng(3).random((40, 60, 3))


def test_an_aligned_patch_is_the_pixels(noise):
    image = Image(width=60, height=40)
    samples = sample_patch(noise, above(), image, floor_patch(1.5, 1.0))
    assert samples.values.shape == (40, 60, 3)
    np.testing.assert_array_equal(samples.values, noise)
    assert samples.cell_area_m2 == pytest.approx(0.05**2, rel=1e-12)
    np.testing.assert_array_equal(samples.coverage, 1)


def test_a_part_of_the_view_is_a_slice_of_the_pixels(noise):
    samples = sample_patch(noise, above(), Image(width=60, height=40), floor_patch(0.5, 0.25, (0.25, 0.0, 0.5)))
    np.testing.assert_array_equal(samples.values, noise[25:35, 25:45])


def test_a_camera_turned_by_90_degrees_gives_the_same_cells(noise):
    straight = sample_patch(noise, above(), Image(width=60, height=40), floor_patch(0.5, 0.5))
    # Looking down with +x up, the image's rows run along -x and its columns along... the patch must not notice.
    turned_camera = above(height=3.0, up=(1.0, 0.0, 0.0))
    view = View.of(turned_camera, Image(width=40, height=60))
    turned = np.empty((60, 40, 3))
    original = View.of(above(), Image(width=60, height=40))
    for row in range(60):
        for column in range(40):
            point = view.point_on_plane(column + 0.5, row + 0.5, np.zeros(3), np.array([0.0, 1.0, 0.0]))
            x, y, _ = original.project(point)
            turned[row, column] = noise[int(y), int(x)]
    again = sample_patch(turned, turned_camera, Image(width=40, height=60), floor_patch(0.5, 0.5))
    np.testing.assert_array_equal(again.values, straight.values)


def test_flux_is_conserved_when_edges_fall_between_pixels(noise):
    # The whole image inside a patch that is larger and shifted by .37 of a pixel: what is covered holds all the flux.
    samples = sample_patch(noise, above(), Image(width=60, height=40), floor_patch(1.7, 1.3, (0.0185, 0.0, 0.011)))
    flux = (samples.values * samples.coverage[..., None]).sum(axis=(0, 1)) * samples.cell_area_m2
    np.testing.assert_allclose(flux, noise.sum(axis=(0, 1)) * 0.05**2, rtol=1e-12)
    assert samples.coverage.sum() * samples.cell_area_m2 == pytest.approx(3.0 * 2.0, rel=1e-12)


def test_a_gradient_is_kept_when_edges_fall_between_pixels():
    ramp = np.broadcast_to((np.arange(60) + 0.5)[None, :, None] * 0.05, (40, 60, 3))
    samples = sample_patch(ramp, above(), Image(width=60, height=40), floor_patch(0.513, 0.5, (0.0137, 0.0, 0.0)))
    truth = 1.5 + 0.0137 + samples.u_m
    np.testing.assert_allclose(samples.values[..., 0], np.broadcast_to(truth, samples.values.shape[:2]), rtol=1e-12)


def test_a_shift_of_037_pixel_moves_the_centroid_by_that():
    spot = np.zeros((40, 60, 3))
    spot[20, 30] = 1.0
    for shift in (0.0, 0.37):
        patch = floor_patch(0.5, 0.5, (0.025 + shift * 0.05, 0.0, 0.025))
        samples = sample_patch(spot, above(), Image(width=60, height=40), patch)
        centroid = (samples.values[..., 0] * samples.u_m).sum() / samples.values[..., 0].sum()
        assert centroid == pytest.approx(-shift * 0.05, abs=1e-12)


def test_a_perspective_view_returns_what_the_plane_shows():
    # Paint L = 1 + x + 2 z on the floor, see it at an angle, and read it back in metres.
    camera = Camera(position=(0.3, 2.0, 3.0), look_at=(0.0, 0.0, 0.0), fov_deg=40.0)
    image = Image(width=200, height=150)
    view = View.of(camera, image)
    picture = np.empty((150, 200, 3))
    for row in range(150):
        for column in range(200):
            x, _, z = view.point_on_plane(column + 0.5, row + 0.5, np.zeros(3), np.array([0.0, 1.0, 0.0]))
            picture[row, column] = 1 + x + 2 * z
    samples = sample_patch(picture, camera, image, floor_patch(0.4, 0.3))
    truth = 1 + samples.u_m[None, :] + 2 * samples.v_m[:, None]
    footprint = 3.6 * 2 * np.tan(np.radians(20)) / 150 / np.sin(np.radians(33))
    # A gradient is kept: what is left is the bend of perspective over a pixel, quadratic in its footprint.
    assert np.abs(samples.values[..., 0] - truth).max() < 2 * footprint**2
    assert samples.values[..., 0].mean() == pytest.approx(1.0, abs=footprint**2 / 4)
    assert samples.coverage.min() == 1.0


def test_a_patch_outside_the_frame_is_uncovered_and_one_behind_the_camera_too(noise):
    image = Image(width=60, height=40)
    assert make_grid(above(), image, floor_patch(0.1, 0.1, (9.0, 0.0, 0.0))).coverage.max() == 0
    camera = Camera(position=(0.0, 1.0, 0.0), look_at=(0.0, 1.0, -1.0), fov_deg=60.0)
    assert make_grid(camera, image, floor_patch(0.1, 0.1, (0.0, 0.0, 3.0))).coverage.max() == 0


def test_halves_and_layers_are_resampled_alike(noise):
    image = Image(width=60, height=40)
    samples = sample_patch(
        noise, above(), image, floor_patch(0.5, 0.5), half_a=noise * 1.1, half_b=noise * 0.9, layers={"caustic": noise}
    )
    np.testing.assert_array_equal(samples.layers["caustic"], samples.values)
    np.testing.assert_allclose(samples.noise, samples.values * 0.1, rtol=1e-9)


def test_an_image_of_another_size_is_refused(noise):
    with pytest.raises(ValueError, match="the scene says"):
        sample_patch(noise, above(), Image(width=61, height=40), floor_patch(0.5, 0.5))
