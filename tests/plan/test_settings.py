"""Settings are what was asked for, to the last bit, or an error that says what they may be."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.commands.command_line import SCENE, run
from tests.plan.small_scenes import ball_over_floor
from vitrail.base.fault import Fault
from vitrail.geometry.world import World
from vitrail.lower.tracer import lower_tracer
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.plan.settings import setting_names

LARGEST_SEED = 2**64 - 1
SEEDS = [2**53 + 1, 2**63 - 1, 2**63, LARGEST_SEED]
"""The first whole number that a double cannot hold, the ends of the range of a signed number, and the largest."""


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("form", [int, str], ids=["number", "text"])
def test_a_seed_is_never_rounded(seed: int, form: type) -> None:
    world = World.of_scene(ball_over_floor())
    assert settings_for(world, analyse(world), seed=form(seed)).seed == seed


@pytest.mark.tracer
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("verb", ["emit", "render"])
def test_a_seed_reaches_the_tracer_and_its_record_as_it_was_typed(verb: str, seed: int, tmp_path: Path) -> None:
    """Typed text, then JSON for the tracer; with render also the tracer's 64 bits and the record that it writes."""
    if verb == "emit":
        result = run("emit", "tracer", SCENE, "--out", tmp_path, "--set", f"seed={seed}")
        record = tmp_path / "scene.json"
    else:
        work = ("--samples", "1", "--photons", "100", "--threads", "1")
        result = run("render", SCENE, "--out", tmp_path / "image.exr", "--seed", seed, *work)
        record = tmp_path / "image.run.json"
    assert result.exit_code == 0, result.output
    assert json.loads(record.read_text(encoding="utf-8"))["settings"]["seed"] == seed


def test_a_number_in_another_form_is_taken_as_the_number_it_is() -> None:
    world = World.of_scene(ball_over_floor())
    plan = analyse(world)
    assert settings_for(world, plan, photons="1e6").photons == 1_000_000
    assert settings_for(world, plan, photons=1e6).photons == 1_000_000
    assert settings_for(world, plan, seed=" 9007199254740993.0 ").seed == 2**53 + 1
    assert settings_for(world, plan, gather_radius_m="1e-3").gather_radius_m == 0.001


def test_the_gather_disc_is_in_records_only_where_it_is_on() -> None:
    world = World.of_scene(ball_over_floor())
    plan = analyse(world)
    off, on = settings_for(world, plan), settings_for(world, plan, gather_disc="true")
    assert (off.gather_disc, on.gather_disc) == (False, True)
    assert "gather_disc" not in off.as_record()
    assert on.as_record() == {**off.as_record(), "gather_disc": True}
    assert "gather_disc" not in lower_tracer(world, plan, off)["settings"]
    assert lower_tracer(world, plan, on)["settings"]["gather_disc"] is True


@pytest.mark.parametrize(
    ("key", "value", "what", "remedy"),
    [
        ("photon", 1, "is no setting", "did you mean `photons`?"),
        ("xyz", 1, "is no setting", f"the settings are {', '.join(setting_names())}"),
        ("samples", "0", "is below 1", "write a whole number from 1 to 1048576"),
        ("samples", "1.5", "is not a whole number", "write one from 1 to 1048576"),
        ("samples", "many", "is not a whole number", "write one from 1 to 1048576"),
        ("samples", True, "is not a whole number", "write one from 1 to 1048576"),
        ("photons", "-1", "is below 0", "write a whole number from 0 to 1099511627776"),
        ("photons", "nan", "is not a whole number", "write one from 0 to 1099511627776"),
        ("photons", "inf", "is not a whole number", "write one from 0 to 1099511627776"),
        ("seed", str(2**64), f"is above {LARGEST_SEED}", f"write a whole number from 0 to {LARGEST_SEED}"),
        ("seed", "1e999999999", "is not a whole number", f"write one from 0 to {LARGEST_SEED}"),
        ("branch_share", "1.5", "is not a share of a look", "write a number from 0 to 1"),
        ("branch_share", "nan", "is not a share of a look", "write a number from 0 to 1"),
        ("gather_radius_m", "0", "is not above 0", "write a length in metres above 0"),
        ("gather_radius_m", "inf", "is not a length", "write a length in metres above 0"),
        ("gather_radius_m", "wide", "is not a length", "write a length in metres above 0"),
        ("solver", "beam", "is not one of auto, photon_map, light_bins, beams", "did you mean `beams`?"),
        ("gather_disc", "often", "is neither true nor false", "write true or false"),
        ("reference_mode", 7, "is not one of auto, native, channels, slices", "choose one of them"),
    ],
)
def test_a_wrong_setting_is_a_fault_of_that_setting(key: str, value: object, what: str, remedy: str) -> None:
    world = World.of_scene(ball_over_floor())
    with pytest.raises(Fault) as raised:
        settings_for(world, analyse(world), **{key: value})  # type: ignore[arg-type]
    fault = raised.value
    assert (fault.what, fault.remedy, fault.path) == (what, remedy, (key,))
    assert str(fault) == f"`{key}` {what}; {remedy}"
