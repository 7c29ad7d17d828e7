"""The accepted images in the repository: usable, explained, small, and still what the tracer makes of their scenes."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.end_to_end.conftest import REFERENCES, ROOT, Compare
from vitrail.judge.stored import IMAGE, read_provenance, read_stored
from vitrail.plan.settings import Settings
from vitrail.scene.load import load
from vitrail.scene.print import scene_hash

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

STORED = sorted(path.parent for path in REFERENCES.glob(f"*/{IMAGE}"))
BUDGET_BYTES = 30_000_000


def scene_of(stored: Path) -> Path:
    (path,) = (ROOT / "scenes").rglob(f"{stored.name}.yaml")
    return path


@pytest.mark.parametrize("stored", STORED, ids=lambda path: path.name)
def test_a_stored_image_shows_its_scene_as_it_is_now_and_says_why_it_was_accepted(stored: Path) -> None:
    loaded = load(scene_of(stored))
    found = read_stored(REFERENCES, stored.name, scene_hash(loaded.scene))
    assert len(found.provenance.because.split()) > 3
    assert found.image.half_a is not None, "without halves no number of it has an interval"


@pytest.mark.parametrize("stored", STORED, ids=lambda path: path.name)
def test_the_recipe_of_a_stored_image_names_every_setting_that_has_no_value_of_its_own(stored: Path) -> None:
    """One that it lacks would take today's usual value, and the image could not be made again."""
    needed = {name for name, setting in Settings.model_fields.items() if setting.is_required()}
    assert needed <= read_provenance(REFERENCES, stored.name).settings.keys()


def test_all_stored_images_together_stay_small_enough_for_git() -> None:
    assert STORED, "no reference is stored"
    assert sum(file.stat().st_size for stored in STORED for file in stored.iterdir()) < BUDGET_BYTES


def test_scenes_without_random_light_still_give_their_stored_images(compared: Compare) -> None:
    """Without POV-Ray: the tracer against itself, at the recipe of each image."""
    names = ("grey_card_directional", "slab_normal", "beer_slab", "tinted_pane_seen")
    results = compared(*(scene_of(REFERENCES / name) for name in names), against=("stored",), quality="normal")
    assert [(scene.name, scene.exit_code, scene.message) for scene in results.scenes] == [(n, 0, "") for n in names]
    assert all(engine.engine == "tracer" for scene in results.scenes for engine in scene.engines)
