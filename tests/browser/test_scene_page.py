"""The page of a scene in a real browser: real clicks and keys, and the radiance of the EXR under the pointer."""

from __future__ import annotations

import base64
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page

from tests.browser.conftest import Watched
from tests.report.synthetic import HEIGHT, WIDTH
from vitrail.images.exr import read_image

pytestmark = pytest.mark.browser

SIDES = ("tracer", "povray")


def open_scene(watched: Watched, report: Path, hash_text: str = "") -> Page:
    page = watched.page
    page.goto(f"{(report / 'apart' / 'index.html').as_uri()}{hash_text}")
    page.wait_for_function("VITRAIL.image('tracer') && VITRAIL.image('povray') && VITRAIL.image('error')")
    # A pointer reaches what is on the screen: the sentences above the pictures may fill it.
    page.evaluate("document.getElementById('stage').scrollIntoView({block: 'center', behavior: 'instant'})")
    return page


def shown_radiance(page: Page, side: str) -> list[float]:
    """What the readout says of a side, to all its figures."""
    cells = page.locator(f"#readout tr[data-side={side}] td")
    return [float(cells.nth(channel).get_attribute("title") or "nan") for channel in range(3)]


def screen_place(page: Page, pane: str, x: int, y: int) -> tuple[float, float]:
    """Where a pixel of the image lies on the screen, from the geometry a reader sees: the image fits its pane."""
    box = page.locator(f"#{pane} canvas").bounding_box()
    assert box is not None
    scale = min(box["width"] / WIDTH, box["height"] / HEIGHT)
    left = box["x"] + box["width"] / 2 - WIDTH / 2 * scale
    top = box["y"] + box["height"] / 2 - HEIGHT / 2 * scale
    return left + (x + 0.5) * scale, top + (y + 0.5) * scale


def stage_pixels(page: Page, pane: str = "pane-a") -> np.ndarray:
    """The pixels of one pane's canvas, (height, width, 4)."""
    width, height, data = page.evaluate(
        """(id) => {
          const canvas = document.querySelector(`#${id} canvas`);
          const copy = Object.assign(document.createElement('canvas'), {width: canvas.width, height: canvas.height});
          const context = copy.getContext('2d', {willReadFrequently: true});
          context.drawImage(canvas, 0, 0);
          const bytes = context.getImageData(0, 0, canvas.width, canvas.height).data;
          let text = '';
          for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
          return [canvas.width, canvas.height, btoa(text)];
        }""",
        pane,
    )
    return np.frombuffer(base64.b64decode(data), dtype=np.uint8).reshape(height, width, 4)


@pytest.mark.parametrize(("pane", "x", "y"), [("pane-a", 48, 42), ("pane-b", 0, 0), ("pane-b", WIDTH - 1, HEIGHT - 1)])
def test_the_radiance_under_the_pointer_is_that_of_the_exr(
    watched: Watched, report: Path, pane: str, x: int, y: int
) -> None:
    page = open_scene(watched, report)
    page.mouse.move(*screen_place(page, pane, x, y))
    assert page.locator("#probe").inner_text() == f"pixel {x}, {y}"
    for side in SIDES:
        stored = read_image(report / "apart" / f"{side}.exr").radiance[y, x]
        # The page holds the float32 of the file: equal, not close.
        assert shown_radiance(page, side) == stored.tolist()
    first = page.locator("#readout tr[data-side=tracer] td").first
    assert float(first.inner_text()) == pytest.approx(shown_radiance(page, "tracer")[0], rel=1e-5)
    watched.check()


def test_flip_shows_one_image_and_then_the_other(watched: Watched, report: Path, tmp_path: Path) -> None:
    page = open_scene(watched, report)
    page.get_by_role("radio", name="Flip").click()
    assert page.locator("#pane-a figcaption").inner_text() == "Tracer"
    tracer = stage_pixels(page)
    page.screenshot(path=str(tmp_path / "flip_tracer.png"))
    page.keyboard.press("f")
    assert page.locator("#pane-a figcaption").inner_text() == "POV-Ray"
    povray = stage_pixels(page)
    assert page.locator("#pane-b").is_hidden()
    assert np.abs(tracer[..., :3].astype(int) - povray[..., :3]).max() > 20, "both pictures are the same"
    page.get_by_role("radio", name="Flip").click()
    assert page.locator("#pane-a figcaption").inner_text() == "Tracer"
    watched.check()


def test_the_slider_uncovers_one_image_from_the_other(watched: Watched, report: Path, tmp_path: Path) -> None:
    page = open_scene(watched, report, "#view=flip")
    tracer = stage_pixels(page)
    page.keyboard.press("f")
    povray = stage_pixels(page)
    page.get_by_role("radio", name="Slider").click()
    page.locator("#slider").scroll_into_view_if_needed()
    box = page.locator("#slider").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] * 0.25, box["y"] + box["height"] / 2, steps=5)
    page.mouse.up()
    assert 0.2 < float(page.locator("#slider").input_value()) < 0.3
    both = stage_pixels(page)
    page.screenshot(path=str(tmp_path / "slider.png"))
    ring = slice(int(both.shape[0] * 0.6), int(both.shape[0] * 0.9))
    left, right = slice(0, both.shape[1] // 4), slice(both.shape[1] // 2, None)
    assert np.array_equal(both[ring, left], tracer[ring, left])
    assert np.array_equal(both[ring, right], povray[ring, right])
    watched.check()


def test_the_difference_is_red_where_the_candidate_is_brighter(watched: Watched, report: Path, tmp_path: Path) -> None:
    page = open_scene(watched, report, "#view=difference")
    x, y = (round(v) for v in np.array(screen_place(page, "pane-a", 48, 42)))
    box = page.locator("#pane-a canvas").bounding_box()
    assert box is not None
    red, green, blue, _ = stage_pixels(page)[y - round(box["y"]), x - round(box["x"])].tolist()
    assert red > 2 * blue and red > 2 * green
    assert page.locator("#scale span").all_inner_texts() == ["−20 %", "+20 %"]
    page.keyboard.press("e")
    page.keyboard.press("e")
    assert page.locator("#scale span").all_inner_texts() == ["−10 %", "+10 %"]
    page.screenshot(path=str(tmp_path / "difference.png"))
    watched.check()


def test_exposure_false_colour_and_layers_change_the_picture(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    plain = stage_pixels(page).astype(int)
    page.keyboard.press("e")
    brighter = stage_pixels(page).astype(int)
    assert brighter[..., :3].sum() > plain[..., :3].sum()
    page.keyboard.press("E")
    assert np.array_equal(stage_pixels(page), plain)
    page.get_by_role("button", name="False colour").click()
    assert page.locator("#scale").is_visible()
    assert not np.array_equal(stage_pixels(page), plain)
    page.keyboard.press("c")
    page.get_by_label("Layer").select_option("caustic")
    page.wait_for_function("VITRAIL.image('tracer.caustic')")
    assert stage_pixels(page)[..., :3].sum() < plain[..., :3].sum()
    watched.check()


def test_both_panes_zoom_together_about_the_pointer(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    place = screen_place(page, "pane-b", 60, 30)
    page.mouse.move(*place)
    page.mouse.wheel(0, -600)
    page.wait_for_function("VITRAIL.get('zoom') === '4'")
    assert page.locator("#probe").inner_text() == "pixel 60, 30"
    page.mouse.move(place[0] + 1, place[1])
    assert page.locator("#probe").inner_text() == "pixel 60, 30", "the pixel under the pointer moved while zooming"
    page.keyboard.press("0")
    assert page.locator("#zoom-value").inner_text() == "100 %"
    watched.check()


def test_everything_can_be_done_with_keys_alone(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    page.locator("#stage").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Shift+ArrowDown")
    assert page.locator("#probe").inner_text() == f"pixel {WIDTH // 2 + 1}, {HEIGHT // 2 + 10}"
    for key, view in zip("12345", ("side", "flip", "slider", "difference", "error"), strict=True):
        page.keyboard.press(key)
        assert page.locator("[role=radio][aria-checked=true]").get_attribute("data-view") == view
    page.keyboard.press("?")
    assert page.locator("#help").is_visible()
    page.keyboard.press("Escape")
    page.keyboard.press("n")
    page.wait_for_url("**/unsure/index.html*")
    page.keyboard.press("u")
    page.wait_for_url(f"**/{report.name}/index.html*")
    watched.check()


def test_an_address_shows_what_its_sender_saw(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    page.keyboard.press("3")
    page.keyboard.press("e")
    page.keyboard.press("o")
    page.mouse.click(*screen_place(page, "pane-a", 50, 40))
    seen = stage_pixels(page)
    address = page.url
    page.goto("about:blank")
    page.goto(address)
    page.wait_for_function("VITRAIL.image('tracer') && VITRAIL.image('povray')")
    assert np.array_equal(stage_pixels(page), seen)
    assert page.locator("#probe").inner_text() == "pixel 50, 40"
    watched.check()


def test_the_patch_of_an_observation_is_brought_into_view(watched: Watched, report: Path) -> None:
    page = open_scene(watched, report)
    page.get_by_role("button", name="Show in the image").click()
    assert float(page.evaluate("VITRAIL.get('zoom')")) == pytest.approx(1.6)
    assert page.evaluate("VITRAIL.get('y')") == "48", "the patch's centre is not in the middle of the stage"
    watched.check()
