"""The published schema is the one of the types, accepts every shipped scene, and refuses what types can refuse."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jsonschema
import pytest

from vitrail.scene.schema import SCHEMA_FILE, scene_schema, schema_text
from vitrail.scene.yaml_tree import YamlProblem, read_yaml

VALIDATOR = jsonschema.Draft202012Validator(scene_schema())
MALFORMED = Path(__file__).parents[1] / "malformed"


def data_of(path: Path) -> Any:
    return read_yaml(path.read_text(encoding="utf-8"))[0]


def test_the_committed_schema_is_current() -> None:
    assert SCHEMA_FILE.read_text(encoding="utf-8") == schema_text(), "run `python -m vitrail.scene.schema`"


def test_the_schema_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(scene_schema())


@pytest.mark.parametrize("path", sorted(Path("scenes").rglob("*.yaml")), ids=lambda path: path.stem)
def test_shipped_scenes_validate(path: Path) -> None:
    VALIDATOR.validate(data_of(path))


BEYOND_TYPES = {
    # Sums and relations between numbers, names and geometry: left to `check`.
    "light_use_above_one", "no_ior", "ior_and_glass", "dispersion_below_zero", "no_light", "light_without_direction",
    "point_light_on_surface", "dangling_material", "duplicate_object", "duplicate_light", "duplicate_observation",
    "box_inside_out", "transmissive_rectangle", "slanted_rectangle", "overlap_without_priority",
    "overlap_of_turned_boxes", "overlap_same_priority", "checker_on_a_sphere", "camera_at_its_target",
    "camera_up_along_view", "camera_without_angle", "camera_inside_an_object", "huge_position", "blinding_light",
    "patch_outside_the_picture", "patch_behind_the_camera", "dispersion_without_direction", "unknown_pattern",
    "prism_crossing_itself", "prism_of_two_corners", "torus_without_a_hole", "lathe_crossing_itself",
    "lens_too_wide", "lens_faces_cross", "mesh_missing",
    "mesh_of_no_kind", "environment_missing", "mesh_with_a_hole", "mesh_inside_out", "mesh_crossing_itself",
    "absorption_without_a_number", "planes_alone", "mesh_without_faces", "mesh_with_a_loose_face", "mesh_overlaps_mesh",
    # Matters of YAML: no JSON value shows them.
    "duplicate_key", "duplicate_section", "number_as_key", "not_a_number", "infinite",
}  # fmt: skip


@pytest.mark.parametrize("path", sorted(MALFORMED.glob("*.yaml")), ids=lambda path: path.stem)
def test_malformed_scenes_are_refused_where_types_can_tell(path: Path) -> None:
    try:
        data = data_of(path)
    except YamlProblem:
        return
    assert VALIDATOR.is_valid(data) == (path.stem in BEYOND_TYPES)
