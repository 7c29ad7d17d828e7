"""Every mutant goes on to the engines: no check of the language stops one that was put in on purpose."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from vitrail.lower.povray import NothingToEdit
from vitrail.pipeline.lowered import job_of, lower
from vitrail.pipeline.request import Request
from vitrail.scene.load import load
from vitrail.study.mutants.bench import BENCH
from vitrail.study.mutants.catalogue import MUTANTS
from vitrail.study.mutants.mutant import Mutant

SCENES = Path(__file__).parents[2] / "scenes"


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.name)
def test_every_mutant_is_lowered_with_its_views_in_each_scene_it_changes(mutant: Mutant, tmp_path: Path) -> None:
    lowered = [name for name, own in BENCH.items() if is_lowered(mutant, name, own, tmp_path)]
    assert lowered, "it changes no scene of the bench"


def is_lowered(mutant: Mutant, name: str, own: Mapping[str, object], out: Path) -> bool:
    """Whether there is something to spoil in this scene. What else stops a mutant is raised."""
    loaded = load(SCENES / f"{name}.yaml")
    request = Request(out=out, defect=mutant.defect, overrides=own, picture_width=1)
    try:
        lower(job_of(loaded, request), request)
    except NothingToEdit:
        return False
    return True
