"""A few hundred damaged files: the reader refuses them by name, or the tracer takes what was read."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.fuzz.__main__ import SCENE
from tests.fuzz.mutations import good_meshes, good_skies
from tests.fuzz.readers import DEFECTS, Outcome, mesh_reader, run, sky_reader

pytestmark = pytest.mark.tracer

COUNT = 150


@pytest.mark.parametrize("what", ["meshes", "skies"])
def test_no_damaged_file_is_a_defect(tmp_path: Path, what: str) -> None:
    scene = json.loads(SCENE.read_text(encoding="utf-8"))
    good, read = (good_meshes(), mesh_reader(scene)) if what == "meshes" else (good_skies(tmp_path), sky_reader(scene))
    found = run(COUNT, 1, good, read, tmp_path)
    assert sum(found.values()) == COUNT and not {each: found[each] for each in DEFECTS if found[each]}
    assert found[Outcome.READ] and found[Outcome.REFUSED], "mutations that change nothing or everything show nothing"


def test_a_reader_that_fails_is_told_from_one_that_refuses(tmp_path: Path) -> None:
    def broken(_path: Path, _lowered: Path) -> Outcome:
        raise KeyError("x")

    assert run(3, 1, good_meshes(), broken, tmp_path) == {Outcome.TRACEBACK: 3}
    assert len(list(tmp_path.glob("defect-*"))) == 3
