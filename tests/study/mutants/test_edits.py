"""Mutants of the translator edit nodes: no layout of the text can disarm them, and none changes nothing in silence."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import pytest

from vitrail.geometry.world import World
from vitrail.lower.povray import NothingToEdit, PovrayScene, lower_povray
from vitrail.lower.povray.text.edit import found
from vitrail.lower.povray.text.printer import Layout, printed
from vitrail.lower.povray.text.sdl import Block, SdlFile
from vitrail.pipeline.defect import Defect
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.load import load
from vitrail.study.mutants.bench import BENCH
from vitrail.study.mutants.catalogue import MUTANTS
from vitrail.study.mutants.mutant import Mutant

SCENES = Path(__file__).parents[3] / "scenes"
WRITTEN = {mutant.name: mutant for mutant in MUTANTS if mutant.defect.povray is not Defect().povray}
"""The mutants that change a scene after it was translated."""
LAYOUTS = {"narrow": Layout(width=1), "wide": Layout(width=10_000, indent="\t")}


@lru_cache
def translated(name: str) -> PovrayScene:
    world = World.of(load(SCENES / f"{name}.yaml"))
    plan = analyse(world)
    photons = {"photons": 1000} if settings_for(world, plan).photons else {}
    return lower_povray(world, plan, settings_for(world, plan, "draft", **photons))


def texts(scene: PovrayScene, layout: Layout) -> list[str]:
    trees = [tree for run in scene.runs for tree in (run.photon_scene, run.pictures[0].scene) if tree is not None]
    return [printed(tree, layout) for tree in trees] + [str(run.gain) for run in scene.runs]


def touched(mutant: Mutant, layout: Layout) -> list[str]:
    """The scenes of the bench whose printed text the mutant changes."""
    names = []
    for name in BENCH:
        clean = translated(name)
        try:
            spoiled = mutant.defect.povray(clean)
        except NothingToEdit:
            continue
        if texts(spoiled, layout) != texts(clean, layout):
            names.append(name)
    return names


@pytest.mark.parametrize("name", WRITTEN)
def test_a_mutant_changes_the_same_scenes_in_every_layout(name: str) -> None:
    usual = touched(WRITTEN[name], Layout())
    assert usual != []
    for layout in LAYOUTS.values():
        assert touched(WRITTEN[name], layout) == usual


@pytest.mark.parametrize("name", WRITTEN)
def test_a_mutant_without_its_nodes_is_an_error(name: str) -> None:
    scene = translated("calibration/ball_lens")
    bare = SdlFile((Block("background", ()),))
    pictures = [tuple(replace(each, scene=bare) for each in run.pictures) for run in scene.runs]
    runs = tuple(
        replace(run, pictures=drawn, photon_scene=bare) for run, drawn in zip(scene.runs, pictures, strict=True)
    )
    with pytest.raises(NothingToEdit):
        WRITTEN[name].defect.povray(replace(scene, runs=runs))


@pytest.mark.parametrize(("name", "scene"), [("missing_pi", "penumbra"), ("weak_photons", "prism_screen")])
def test_lights_of_several_lines_are_changed_too(name: str, scene: str) -> None:
    """Edits of the finished text missed every light that was too long for one line."""
    clean = translated(f"calibration/{scene}")
    spoiled = WRITTEN[name].defect.povray(clean)
    before, after = (made.runs[0].photon_scene or made.runs[0].pictures[0].scene for made in (clean, spoiled))
    lights = list(zip(found(before, "light_source"), found(after, "light_source"), strict=True))
    assert lights
    assert all(old != new for old, new in lights)


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS)
def test_a_layout_changes_blanks_alone(layout: Layout) -> None:
    for name in BENCH:
        for usual, other in zip(texts(translated(name), Layout()), texts(translated(name), layout), strict=True):
            assert other.split() == usual.split()
