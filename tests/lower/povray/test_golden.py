"""The emitted scene text, word for word."""

from __future__ import annotations

import pytest

from tests.lower.povray.golden import GOLDEN, SCENES, emitted


@pytest.mark.parametrize("name", SCENES)
def test_the_scene_text_is_the_accepted_one(name: str) -> None:
    kept = {path.name: path.read_text(encoding="ascii") for path in GOLDEN.glob(f"{name}.*.pov")}
    assert emitted(name) == kept, "read the difference, then accept it with `python -m tests.lower.povray.golden`"


def test_no_kept_text_is_without_its_scene() -> None:
    assert {path.name.split(".")[0] for path in GOLDEN.glob("*.pov")} == set(SCENES)


def test_a_plan_without_a_caustic_emits_no_photons() -> None:
    for name in ("grey_card_directional", "grey_card_point", "slab_tilted"):
        for text in emitted(name).values():
            assert "photons" not in text


def test_a_plan_without_dispersion_or_absorption_emits_neither() -> None:
    for name in SCENES:
        for text in emitted(name).values():
            assert "dispersion" not in text and "media" not in text and "radiosity" not in text
