"""A changed copy keeps the rules of its type, which pydantic's own ``model_copy`` does not look at."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from vitrail.base.changed import changed, unchecked
from vitrail.scene.model import Cylinder, Material, Sphere

BALL = Sphere(center=(0, 1, 0), radius=2)


def test_a_changed_copy_differs_in_what_was_changed() -> None:
    assert changed(BALL, radius=3) == Sphere(center=(0, 1, 0), radius=3)
    assert BALL.radius == 2


def test_a_field_is_named_as_in_the_program_where_a_file_names_it_otherwise() -> None:
    rod = Cylinder.model_validate({"from": (0, 0, 0), "to": (0, 1, 0), "radius": 1})
    assert changed(rod, from_=(0, -1, 0)).from_ == (0, -1, 0)


@pytest.mark.parametrize("fields", [{"radius": -1}, {"radius": "wide"}, {"radius": None}])
def test_a_copy_that_its_type_refuses_is_refused(fields: dict[str, object]) -> None:
    BALL.model_copy(update=fields)  # nobody looks
    with pytest.raises(ValidationError):
        changed(BALL, **fields)


def test_a_field_that_does_not_exist_is_refused() -> None:
    BALL.model_copy(update={"raduis": 5})  # nobody looks
    for change in (changed, unchecked):
        with pytest.raises(TypeError, match="Sphere has no raduis"):
            change(BALL, raduis=5)


def test_the_rules_between_fields_hold_for_a_copy_too() -> None:
    with pytest.raises(ValidationError, match="which makes light"):
        changed(Material(diffuse=(0.5,) * 3), reflection=(0.6,) * 3)


def test_a_defect_may_break_a_rule() -> None:
    assert unchecked(BALL, radius=-1).radius == -1
    assert unchecked(BALL, radius=-1).center == BALL.center
