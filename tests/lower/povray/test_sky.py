"""An image of the sky in the real POV-Ray: where its pixels are, how bright they light, what is refused."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from tests.lower.povray.real_povray import HALF_FLOAT, lowered, rendered, scene
from vitrail.base.phenomenon import Phenomenon
from vitrail.images.exr import write_image
from vitrail.lower.povray import NotTranslatable
from vitrail.lower.povray.text.emitters import Grid, sphere_directions
from vitrail.lower.povray.text.sky import BRIGHTEST, Sky

pytestmark = pytest.mark.povray

GREY = "card: {diffuse: 0.8}"
CARD = "- {name: card, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: card}"
SPOT_OF_CARD = "camera: {kind: orthographic, position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, -1], height: 0.01}"
TINY = "image: {width: 4, height: 4}"
RADIANCE = (1.0, 5.0, 50.0)


def sky(folder: Path, pixels: np.ndarray, name: str = "sky") -> str:
    write_image(folder / f"{name}.exr", pixels)
    return f"- {{name: {name}, environment: {{file: {folder}/{name}.exr}}}}"


def numbered() -> np.ndarray:
    """8 x 4 pixels, each with its own radiance, from 1 to 4000."""
    row, column = np.mgrid[0:4, 0:8]
    return np.stack([1.0 + column + 8 * row, np.where(column % 2, 5.0, 50.0), 1000.0 * (1 + row)], axis=2)


@pytest.mark.parametrize("is_second", [False, True])
def test_an_image_of_one_radiance_is_the_constant_environment(is_second: bool) -> None:
    """The same small lights in the same order, to the rounding of sines and sums."""
    grid = Grid(24, 7, is_second)
    lights = Sky(np.broadcast_to(RADIANCE, (4, 8, 3))).directions(grid)
    constant = sphere_directions(grid)
    assert np.array([way for way, _ in lights]) == pytest.approx(np.array([each.direction for each in constant]))
    wanted = np.outer([4 * math.pi * each.share for each in constant], RADIANCE)
    assert np.array([irradiance for _, irradiance in lights]) == pytest.approx(wanted)


def test_every_direction_shows_its_pixel(tmp_path: Path) -> None:
    """A mirror ball seen from +z shows nearly all directions; the axes are those of OpenEXR's environment maps."""
    ball = "- {name: ball, sphere: {center: [0, 0, 0], radius: 1}, material: mirror}"
    camera = "camera: {kind: orthographic, position: [0, 0, 5], look_at: [0, 0, 0], up: [0, 1, 0], height: 2}"
    seen = rendered(scene("mirror: {reflection: 1}", ball, sky(tmp_path, numbered()), camera)).image.radiance
    x, y = np.meshgrid((np.arange(32) + 0.5) / 16 - 1, 1 - (np.arange(32) + 0.5) / 16)
    on_ball = x * x + y * y < 1
    x, y = x[on_ball], y[on_ball]
    # Mirror -z at the normal.
    facing = np.sqrt(1 - x * x - y * y)
    way = np.stack([2 * facing * x, 2 * facing * y, 2 * facing**2 - 1])
    column = ((0.5 - np.arctan2(way[0], way[2]) / (2 * math.pi)) * 8).astype(int)
    row = (np.arccos(way[1]) / math.pi * 4).astype(int)
    assert len({*zip(row.tolist(), column.tolist(), strict=True)}) == 32
    assert seen[on_ball] == pytest.approx(numbered()[row, column], rel=2 * HALF_FLOAT)


@pytest.mark.parametrize(
    ("normal", "up", "bright"),
    [
        ((0, 1, 0), (0, 0, -1), np.s_[:4]),
        ((1, 0, 0), (0, 1, 0), np.s_[:, :8]),
        ((0, 0, 1), (0, 1, 0), np.s_[:, 4:12]),
    ],
    ids=["above", "towards +x", "towards +z"],
)
def test_half_a_sky_lights_the_card_that_faces_it(
    tmp_path: Path, normal: tuple[int, ...], up: tuple[int, ...], bright: tuple[slice, ...]
) -> None:
    """As bright as the albedo times its radiance. 1 %: 89 directions a half."""
    pixels = np.zeros((8, 16, 3))
    pixels[bright] = RADIANCE
    card = f"- {{name: card, plane: {{point: [0, 0, 0], normal: {list(normal)}}}, material: card}}"
    camera = (
        f"camera: {{kind: orthographic, position: {[each / 2 for each in normal]}, look_at: [0, 0, 0],"
        f" up: {list(up)}, height: 0.01}}"
    )
    seen = rendered(scene(GREY, card, sky(tmp_path, pixels), camera, TINY))
    assert seen.mean == pytest.approx(0.8 * np.array(RADIANCE), rel=0.01)


def test_a_pixel_like_the_sun_casts_its_light_and_fits_half_floats(tmp_path: Path) -> None:
    """E = L solid angle cos, from one of 8192 pixels; 1e-3: the cosine changes by 3 % over it and cancels evenly."""
    pixels = np.zeros((64, 128, 3))
    pixels[16, 80] = (1e6, 2e6, 5e7)
    loaded = scene(GREY, CARD, sky(tmp_path, pixels), SPOT_OF_CARD, TINY)
    top, bottom = math.cos(math.pi * 16 / 64), math.cos(math.pi * 17 / 64)
    irradiance = pixels[16, 80] * 2 * math.pi / 128 * (top**2 - bottom**2) / 2
    seen = rendered(loaded)
    assert seen.mean == pytest.approx(0.8 / math.pi * irradiance, rel=1e-3)
    assert all(run.sky is not None and 0 < run.sky.pixels.max() <= BRIGHTEST for run in seen.lowered.runs)


def test_coloured_skies_shoot_photons_one_channel_at_a_time(tmp_path: Path) -> None:
    pane = "\n- {name: pane, box: {min: [-2, 0.2, -2], max: [2, 0.3, 2]}, material: clear}"
    materials = f"{GREY}\nclear: {{transmission: 1, ior: 1}}"
    # Red on one side and blue on the other are white on the whole.
    pixels = np.zeros((4, 8, 3))
    pixels[:, :4], pixels[:, 4:] = (2, 1, 0), (0, 1, 2)
    coloured = lowered(scene(materials, CARD + pane, sky(tmp_path, pixels), SPOT_OF_CARD))
    grey = lowered(scene(materials, CARD + pane, sky(tmp_path, np.ones((4, 8, 3)), "grey"), SPOT_OF_CARD))
    assert (coloured.mode.name, len(coloured.runs)) == ("channels", 6)
    assert (grey.mode.name, len(grey.runs)) == ("native", 2)
    for run in coloured.runs:
        assert run.sky is not None and f'exr "{run.sky.name}"' in run.sdl and run.sky.name.isascii()
    laws = [entry.target_law for entry in grey.certificate.of(Phenomenon.SHADOW)]
    assert any("lattice of equal power" in law for law in laws)
    assert [each.residual for each in grey.certificate.of(Phenomenon.REFRACTION) if "pixels" in each.target_law]


def test_no_pixel_outshines_half_floats_where_photons_set_the_light(tmp_path: Path) -> None:
    """A sun of one pixel, 1e7 times the sky: the factor that photons ask for would make it 1e5."""
    pane = "\n- {name: pane, box: {min: [-2, 0.2, -2], max: [2, 0.3, 2]}, material: clear}"
    pixels = np.ones((64, 128, 3))
    pixels[20, 7] = 1e7
    made = lowered(scene(f"{GREY}\nclear: {{transmission: 1, ior: 1}}", CARD + pane, sky(tmp_path, pixels)))
    assert made.photons is not None
    for run in made.runs:
        assert run.sky is not None and BRIGHTEST / 2 < run.sky.pixels.max() <= BRIGHTEST


@pytest.mark.parametrize("pixel", [-1.0, math.nan, math.inf])
def test_pixels_that_are_no_radiance_are_refused_at_their_line(tmp_path: Path, pixel: float) -> None:
    pixels = np.ones((4, 8, 3))
    pixels[2, 3, 1] = pixel
    with pytest.raises(
        NotTranslatable, match=r"scene\.yaml:\d+:\d+: .* at pixel x=3 y=2 \(channel G\); make all of it finite"
    ):
        lowered(scene(GREY, CARD, sky(tmp_path, pixels), SPOT_OF_CARD, TINY))


def test_a_second_image_is_refused(tmp_path: Path) -> None:
    both = "\n".join(sky(tmp_path, np.ones((2, 4, 3)), name) for name in ("one", "two"))
    with pytest.raises(NotTranslatable, match="add the images up into one"):
        lowered(scene(GREY, CARD, both, SPOT_OF_CARD, TINY))
