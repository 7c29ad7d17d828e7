"""What the tracer is given, word for word, for scenes whose every part can be followed by eye."""

from __future__ import annotations

import base64
import json
import math
from pathlib import Path

import numpy as np
import pytest

from vitrail.base.canonical_json import canonical_json
from vitrail.check.check import check_file
from vitrail.geometry.world import World
from vitrail.images.exr import write_image
from vitrail.lower.tracer import lower_tracer
from vitrail.optics.glass import glass_named
from vitrail.plan.analyse import analyse, everything
from vitrail.plan.budget import settings_for
from vitrail.plan.views import ObservationView
from vitrail.scene.load import load_text
from vitrail.scene.model import Image
from vitrail.scene.print import scene_hash

GOLDEN = Path(__file__).parents[1] / "golden"
NAMES = ("plain", "prism", "every_part")


def unpack(text: str, type_: str) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), "<" + type_)


def lowered(name: str, *, all_on: bool = False, **options: object) -> dict:
    scene = check_file(GOLDEN / f"{name}.yaml").scene_or_raise().scene
    world = World.of_scene(scene)
    plan = everything(world) if all_on else analyse(world)
    return lower_tracer(world, plan, settings_for(world, plan), **options)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", NAMES)
def test_the_lowered_text_is_the_one_that_was_looked_at(name: str, tmp_path: Path) -> None:
    """To accept a change, look at the difference and copy the file that the message names."""
    obtained = canonical_json(lowered(name))
    expected = GOLDEN / f"{name}.json"
    (tmp_path / expected.name).write_text(obtained, encoding="utf-8")
    assert expected.is_file(), f"there is no {expected}; look at {tmp_path / expected.name} and copy it there"
    assert obtained == expected.read_text(encoding="utf-8"), f"diff {expected} {tmp_path / expected.name}"


def test_views_are_pictures_more_with_cameras_of_their_own() -> None:
    scene = check_file(GOLDEN / "plain.yaml").scene_or_raise().scene
    world = World.of_scene(scene)
    plan = analyse(world)
    camera = scene.camera.model_copy(
        update={"position": (0.0, 4.0, 0.0), "look_at": (0.0, 0.0, 0.0), "up": (0.0, 0.0, -1.0)}
    )
    view = ObservationView("spot", ("spot", "rim"), camera, Image(width=40, height=20), 16)
    plain = lower_tracer(world, plan, settings_for(world, plan))
    made = lower_tracer(world, plan, settings_for(world, plan), views=(view,))
    assert "views" not in plain
    views = made.pop("views")
    assert made == plain
    assert [(one["name"], one["image"], one["samples"]) for one in views] == [("spot", {"width": 40, "height": 20}, 16)]
    own, seen = plain["camera"], views[0]["camera"]
    assert set(seen) == set(own)
    assert (seen["kind"], seen["position"], seen["forward"]) == (own["kind"], (0, 4, 0), (0, -1, 0))
    assert seen["half_width"] == pytest.approx(2 * seen["half_height"])


def part(scene: dict, key: str, name: str) -> dict:
    return next(item for item in scene[key] if item["name"] == name)


def test_shapes_are_moved_into_the_world() -> None:
    scene = lowered("every_part")
    assert part(scene, "objects", "ball")["shape"] == {"kind": "sphere", "center": (-4, 0.5, 0), "radius": 0.5}
    card = part(scene, "objects", "card")["shape"]
    assert (card["center"], card["u"], card["v"]) == ((6, 1, 0), (0, 0, -1), (0, 1, 0))
    assert part(scene, "objects", "floor")["shape"]["normal"] == (0, 1, 0)
    rod = part(scene, "objects", "rod")["shape"]
    assert (rod["from"], rod["to"]) == ((3, 0.5, 0), (2, 0.5, 0))
    assert part(scene, "objects", "cube")["shape"]["frame"]["identity"] is True
    frame = part(scene, "objects", "block")["shape"]["frame"]
    assert frame["identity"] is False
    assert frame["rotation"][0] == pytest.approx((math.cos(math.pi / 6), 0, math.sin(math.pi / 6)))


def test_a_clockwise_profile_is_turned_around() -> None:
    corners = part(lowered("every_part"), "objects", "bar")["shape"]["corners"]
    assert corners == ((1, 0), (0, 1), (0, 0))


def test_only_used_materials_are_lowered_and_indices_point_at_them() -> None:
    scene = lowered("every_part")
    names = [material["name"] for material in scene["materials"]]
    assert "unused" not in names
    assert names[part(scene, "objects", "wedge")["material"]] == "sf10"


def test_attenuation_becomes_coefficients() -> None:
    """-ln(color) / distance, 1/m."""
    smoky = part(lowered("every_part"), "materials", "smoky")
    assert smoky["absorption_per_m"] == pytest.approx((10 * math.log(2), 10 * math.log(4), 0))


def test_dispersive_glass_has_an_index_for_each_band_and_one_for_the_camera() -> None:
    scene = lowered("prism")
    assert [band["name"] for band in scene["bands"]] == ["red", "yellow", "green", "blue"]
    flint = part(scene, "materials", "flint")
    assert flint["ior_by_band"] == pytest.approx((1.6, 1.632, 1.664, 1.696), abs=1e-15)
    assert flint["camera_ior"] == 1.6


def test_nearly_matched_glass_keeps_the_digits_that_the_scene_gives() -> None:
    """In binary 1.000000000001 - 1 is 1.000089e-12 [O 2.2]."""
    from vitrail.scene.load import load_text

    text = (GOLDEN / "plain.yaml").read_text(encoding="utf-8").replace("ior: 1.5", "ior: 1.000000000001")
    scene = load_text(text).scene
    world = World.of_scene(scene)
    plan = analyse(world)
    made = lower_tracer(world, plan, settings_for(world, plan))
    assert part(made, "materials", "clear")["ior_minus_one_by_band"] == [1e-12]


def test_one_wavelength_alone_is_one_band_of_that_index() -> None:
    scene = lowered("every_part", all_on=True, wavelength_nm=587.5618)
    assert len(scene["bands"]) == 1
    assert part(scene, "materials", "sf10")["ior_by_band"] == (glass_named("SF10").n_d,)


def test_a_plan_takes_out_what_it_does_not_need_and_everything_does_not() -> None:
    needed, full = lowered("plain"), lowered("plain", all_on=True)
    assert needed["transport"] == {"indirect": "none", "max_reflections": 0, "max_transmissions": 2}
    assert full["transport"] == {"indirect": "none", "max_reflections": 8, "max_transmissions": 64}
    assert not needed["plan"]["reflection"]
    assert full["plan"]["reflection"]


def test_meshes_and_skies_are_in_the_input_to_the_last_digit(tmp_path: Path) -> None:
    text = (
        (GOLDEN / "plain.yaml")
        .read_text(encoding="utf-8")
        .replace("sphere: {center: [0, 2, 0], radius: 1}", "mesh: {file: ball.obj, smooth: false}")
        .replace("lights:", "lights:\n  - {name: sky, environment: {file: sky.exr}}")
    )
    (tmp_path / "ball.obj").write_text("v 0 0 0\nv 0.333333333333333315 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n")
    write_image(tmp_path / "sky.exr", np.arange(24, dtype=float).reshape(2, 4, 3) / 3)
    world = World.of_scene(load_text(text).scene, tmp_path)
    plan = analyse(world)
    made = lower_tracer(world, plan, settings_for(world, plan))
    mesh, sky = made["objects"][1]["shape"], made["lights"][0]["image"]
    assert unpack(mesh["vertices"], "f8")[3] == 1 / 3 and "normals" not in mesh
    assert unpack(mesh["triangles"], "u4").tolist() == [0, 1, 3, 0, 3, 2]
    assert (sky["width"], sky["height"]) == (4, 2)
    assert np.array_equal(unpack(sky["radiance"], "f4"), np.arange(24, dtype=np.float32) / np.float32(3))
    assert str(tmp_path) not in canonical_json(made)


def test_the_hash_is_that_of_the_whole_scene_whatever_the_plan() -> None:
    scene = check_file(GOLDEN / "plain.yaml").scene_or_raise().scene
    assert lowered("plain")["scene_hash"] == lowered("plain", all_on=True)["scene_hash"] == scene_hash(scene)


def test_canonical_json_reads_back_and_does_not_depend_on_the_order_of_keys() -> None:
    value = {"b": [1.5, (2, [3.0])], "a": {"y": None, "x": True}, "c": [{"z": 'ü"\n'}, {}], "d": []}
    text = canonical_json(value)
    assert json.loads(text) == json.loads(json.dumps(value))
    assert text == canonical_json(dict(reversed(value.items())))
    assert text.endswith("}\n")


def test_canonical_json_keeps_every_digit_and_drops_the_sign_of_zero() -> None:
    assert canonical_json([0.1 + 0.2, 5e-324, 1e300, -0.0]) == "[0.30000000000000004, 5e-324, 1e+300, 0.0]\n"


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
def test_canonical_json_refuses_what_is_no_number(number: float) -> None:
    with pytest.raises(ValueError, match="cannot be written"):
        canonical_json({"a": [number]})
