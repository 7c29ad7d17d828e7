"""The atlas finds by itself the limits of POV-Ray that our notes measured by hand, and none of the tracer's."""

from __future__ import annotations

from pathlib import Path

import pytest

from vitrail.base.record import read_record
from vitrail.report.atlas_page import write_atlas_page
from vitrail.study.extremes.atlas import AXES, run_atlas
from vitrail.study.extremes.records import Atlas

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

KNOWN = {
    # axis: (low, high) of the first failing value in POV-Ray, from the notes [P 2.4, 2.7, 7] with the bisection's 5 %
    "thickness": (9e-5, 1.05e-4),  # MIN_ISECT_DEPTH 1e-4
    "photon_flux": (30.0, 34.0),  # the shared exponent ends at 32
    "offset": (1e6, 1e7),  # float32 positions: spacing 1/16 is one unit in the last place at 1e6
    "large_scale": (1.7e6, 2.1e6),  # the wall is 5 radii from the camera, MAX_DISTANCE is 1e7
    "depth": (128, 128),  # trace level 256, two a pane
}


@pytest.fixture(scope="module")
def atlas(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Atlas]:
    out = tmp_path_factory.mktemp("atlas")
    return out, run_atlas(out, jobs=2, axes=[axis for axis in AXES if axis.name in KNOWN])


@pytest.mark.parametrize("name", sorted(KNOWN))
def test_povray_fails_where_our_notes_say(atlas: tuple[Path, Atlas], name: str) -> None:
    record = next(axis for axis in atlas[1].axes if axis.name == name)
    low, high = KNOWN[name]
    assert low <= record.engines["povray"].first_failing <= high


@pytest.mark.parametrize("name", sorted(KNOWN))
def test_the_tracer_holds_or_says_why_not(atlas: tuple[Path, Atlas], name: str) -> None:
    found = next(axis for axis in atlas[1].axes if axis.name == name).engines["tracer"]
    assert found.failure is None
    assert found.first_failing is None or found.limit


def test_each_failure_comes_with_its_scene_in_both_languages(atlas: tuple[Path, Atlas]) -> None:
    out, found = atlas
    for axis in found.axes:
        for engine, record in axis.engines.items():
            if record.first_failing is not None:
                assert (out / "scenes" / f"{axis.name}-{engine}.yaml").read_text().startswith("vitrail: 1")
                assert "#version 3.7" in (out / "scenes" / f"{axis.name}-{engine}.pov").read_text()


def test_the_page_shows_every_axis_and_says_nothing_else(atlas: tuple[Path, Atlas]) -> None:
    out, found = atlas
    page = write_atlas_page(out, found).read_text()
    assert read_record(Atlas, out / "atlas.json") == found
    assert all(f'id="{name}"' in page for name in KNOWN)
