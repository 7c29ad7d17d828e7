"""Every mutant goes on to the engines: no check of the language stops one that was put in on purpose."""

from __future__ import annotations

from pathlib import Path

import pytest

from vitrail.lower.povray import NothingToEdit
from vitrail.pipeline.lowered import job_of, lower
from vitrail.pipeline.request import Request
from vitrail.scene.load import load
from vitrail.study.mutants.catalogue import MUTANTS

SCENE = Path(__file__).parents[2] / "scenes" / "calibration" / "reflecting_prism.yaml"


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.name)
def test_every_mutant_is_lowered_with_its_views(mutant, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    loaded, request = load(SCENE), Request(out=tmp_path, defect=mutant.defect, picture_width=1)
    try:
        lower(job_of(loaded, request), request)
    except NothingToEdit:
        pytest.skip("it changes nothing in this scene")
