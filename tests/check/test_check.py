"""Cross checks that need more than one line of a file: what is legal, what is warned of, what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from vitrail.check.check import check_file, check_text
from vitrail.scene.diagnostic import SceneErrors

SHIPPED = sorted(Path("scenes").rglob("*.yaml"))

SCENE = """\
vitrail: 1
camera: {position: [0, 2, 5], look_at: [0, 0.5, 0], fov_deg: 35}
image: {width: 64, height: 48}
materials:
  table: {diffuse: 0.8}
  clear: {transmission: 1, ior: 1.5}
  air: {transmission: 1, ior: 1}
objects:
  - {name: table, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: table}
  - {name: ball, sphere: {center: [0, 1, 0], radius: 0.5}, material: clear}
  - {name: bubble, sphere: {center: [0, 1, 0], radius: 0.2}, material: air, priority: 1}
lights:
  - {name: sun, directional: {direction: [0.3, -1, 0], irradiance: 3}}
observe:
  - {name: spot, phenomenon: caustic, patch: {center: [0.4, 0, 0.2], u: [0.5, 0, 0], v: [0, 0, 0.5]}}
"""


def changed(*replacements: tuple[str, str]) -> str:
    text = SCENE
    for old, new in replacements:
        assert old in text
        text = text.replace(old, new)
    return text


def errors(text: str) -> list[str]:
    return [each.what for each in check_text(text).errors]


def warnings(text: str) -> list[str]:
    result = check_text(text)
    assert not result.errors
    return [each.what for each in result.warnings]


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_shipped_scenes_pass_without_a_warning(path: Path) -> None:
    assert [str(each) for each in check_file(path).diagnostics] == []


def test_nested_glass_is_legal_with_priority() -> None:
    assert errors(SCENE) == [] and warnings(SCENE) == []
    assert "overlaps" in errors(changed((", priority: 1", "")))[0]


def test_glass_may_touch_glass_and_contain_opaque_things() -> None:
    touching = "  - {name: cube, box: {min: [0.5, 0.5, -0.5], max: [1, 1.5, 0.5]}, material: clear}\nlights:"
    assert warnings(changed(("lights:", touching))) == []
    assert (
        warnings(changed(("material: air, priority: 1", "material: table"), ("  air: {transmission: 1, ior: 1}\n", "")))
        == []
    )


def test_glass_below_the_surface_of_water_needs_a_priority() -> None:
    """A transmissive plane is a half space full of it."""
    water = changed(("table: {diffuse: 0.8}", "table: {transmission: 1, ior: 1.33}"), ("radius: 0.5}", "radius: 1.2}"))
    assert any("overlaps" in each for each in errors(water))


def test_a_sea_over_its_bed_is_no_glass_that_sank_into_the_floor() -> None:
    """Glass that fills a half space ends at an opaque plane or nowhere."""
    sea = "  - {name: sea, plane: {point: [0, 0.4, 0], normal: [0, 1, 0]}, material: air, priority: 0}\nlights:"
    assert not any("cuts `sea`" in each for each in warnings(changed(("lights:", sea))))


WARNED = {
    "a plane through glass": ([("point: [0, 0, 0]", "point: [0, 0.75, 0]")], "the plane `table` cuts `ball`"),
    "an idle material": ([("  air:", "  idle: {diffuse: 0.1}\n  air:")], "no object uses the material `idle`"),
    "fresnel without glass": ([("diffuse: 0.8", "diffuse: 0.8, ior: 1.5, fresnel: true")], "`fresnel` of `table`"),
    "roughness without glass": ([("diffuse: 0.8", "diffuse: 0.8, roughness: 0.1")], "`roughness` of `table`"),
    "dispersion without glass": ([("diffuse: 0.8", "diffuse: 0.8, dispersion: 0.1")], "`dispersion` of `table`"),
    "a dark light": ([("irradiance: 3", "irradiance: 0")], "the light `sun` is dark"),
    "a lamp inside a solid": (
        [("lights:", "  - {name: pot, sphere: {center: [3, 1, 0], radius: 0.5}, material: table}\nlights:"),
         ("observe:", "  - {name: lamp, point: {position: [3, 1, 0], intensity: 1}}\nobserve:")],
        "the light `lamp` is inside the opaque `pot`",
    ),
    "glow that lights nothing": (
        [("  - {name: sun, directional: {direction: [0.3, -1, 0], irradiance: 3}}", "  []"),
         ("clear: {transmission: 1,", "clear: {emission: 1, transmission: 1,")],
        "the emission of `clear` is seen but lights nothing",
    ),
    "a patch half out of the picture": ([("center: [0.4, 0, 0.2]", "center: [1.9, 0, 0.2]")], "corners are outside"),
    "a patch in the air": ([("center: [0.4, 0, 0.2]", "center: [0.4, 0.01, 0.2]")], "lies on no object's surface"),
    "a patch seen edge-on": (
        [("position: [0, 2, 5], look_at: [0, 0.5, 0]", "position: [0, 0.01, 5], look_at: [0, 0, 0]")],
        "seen edge-on",
    ),
    "a caustic seen through the ball": (
        [("center: [0.4, 0, 0.2]", "center: [0, 0, -2.2]")],
        "through `ball`, which bends the view",
    ),
    "sizes far apart": (
        [("lights:", "  - {name: earth, sphere: {center: [0, -1e8, -1e6], radius: 1e7}, material: table}\n"
                     "  - {name: dust, sphere: {center: [1, 1, 0], radius: 1e-3}, material: table}\nlights:")],
        "the scene spans sizes from 0.001 m to 1e+07 m",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", WARNED)
def test_what_is_legal_but_probably_not_meant(case: str) -> None:
    replacements, expected = WARNED[case]
    found = warnings(changed(*replacements))
    assert any(expected in each for each in found), found


def test_a_patch_of_less_than_a_pixel_is_refused() -> None:
    text = changed(("center: [0.4, 0, 0.2], u: [0.", "center: [0.4, 0, 0.2], u: [0.0000"))
    (error,) = check_text(text).errors
    assert "pixels wide in the picture, which leaves nothing to measure" in error.what


def test_a_patch_behind_an_opaque_object_is_reported() -> None:
    text = changed(("material: air, priority: 1", "material: table"), ("center: [0.4, 0, 0.2]", "center: [0, 0, -5]"))
    assert any("`bubble` hides the patch" in each.what for each in check_text(text).diagnostics)


def test_an_invalid_scene_cannot_be_taken_further() -> None:
    with pytest.raises(SceneErrors, match="no material"):
        check_text(changed(("material: clear", "material: glass"))).scene_or_raise()


def test_warnings_do_not_stop_a_scene() -> None:
    result = check_text(changed(("irradiance: 3", "irradiance: 0")))
    assert result.is_valid and str(result.warnings[0]).startswith(
        "scene.yaml:13:30: warning: the light `sun` is dark; "
    )


def test_the_example_of_the_language_is_a_scene() -> None:
    page = Path("scenes/README.md").read_text(encoding="utf-8")
    example = page.split("```yaml\n")[1].split("```")[0]
    assert [str(each) for each in check_text(example).diagnostics] == []


def test_a_closed_object_around_camera_and_lamp_is_a_room() -> None:
    """The inner face of a sphere may be the scene; without a lamp inside, the camera is buried."""
    room = Path("scenes/calibration/closed_room.yaml").read_text(encoding="utf-8")
    assert [str(each) for each in check_text(room).diagnostics] == []
    buried = room.replace("point: {position: [0, 0, 0]", "point: {position: [0, 9, 0]")
    assert "the camera is inside the opaque `room`" in errors(buried)
