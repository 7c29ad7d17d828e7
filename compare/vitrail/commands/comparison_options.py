"""What the verbs that compare scenes share: which scenes, which settings, who watches."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from vitrail.commands.errors import usage_error

if TYPE_CHECKING:
    from vitrail.base.progress import Progress
    from vitrail.pipeline.defect import Defect
    from vitrail.plan.settings import Quality
    from vitrail.scene.diagnostic import Diagnostic
    from vitrail.scene.load import Loaded


def load_all(paths: Sequence[Path]) -> list[Loaded]:
    """Every scene, folders searched through; nothing is rendered before all of them are right.

    Raises SceneErrors with the errors of all scenes.
    """
    from vitrail.commands.scene_file import read_scene
    from vitrail.scene.diagnostic import SceneErrors

    loaded: list[Loaded] = []
    errors: list[Diagnostic] = []
    for path in scene_files(paths):
        try:
            loaded.append(read_scene(path))
        except SceneErrors as found:
            errors += found.diagnostics
    if errors:
        raise SceneErrors(errors)
    if not loaded:
        raise usage_error(f"{', '.join(map(str, paths))}: no scene found; name scene files or folders that hold some")
    return loaded


def scene_files(paths: Sequence[Path]) -> list[Path]:
    """The named files, and of named folders everything that ends in .yaml."""
    found = []
    for path in paths:
        found += sorted(path.rglob("*.yaml")) if path.is_dir() else [path]
    return list(dict.fromkeys(found))


def overrides_of(loaded: Sequence[Loaded], quality: Quality, assignments: Sequence[str]) -> dict[str, object]:
    """``--set KEY=VALUE`` as a mapping, tried on every scene before anything is rendered."""
    from vitrail.commands.settings_options import prepared

    for each in loaded:
        prepared(each, quality, list(assignments))
    parts = [assignment.partition("=") for assignment in assignments]
    return {key.strip(): value.strip() for key, _, value in parts}


def defect_named(name: str) -> Defect:
    """A known mistake by its name; the empty name is none."""
    from vitrail.pipeline.defect import Defect
    from vitrail.pipeline.defects import DEFECTS

    if name and name not in DEFECTS:
        raise usage_error(f"--inject-defect {name}: there is no such defect; the known ones are {', '.join(DEFECTS)}")
    return DEFECTS[name] if name else Defect()


@contextmanager
def reference_errors() -> Iterator[None]:
    """References and images that cannot be used are errors of use: their message, exit code 2."""
    from vitrail.images.exr import ImageError
    from vitrail.judge.reference_files import ReferencesError
    from vitrail.judge.thresholds import ThresholdError

    try:
        yield
    except (ReferencesError, ThresholdError, ImageError) as error:
        raise usage_error(str(error)) from None


@contextmanager
def watching(scenes: int, *, verbose: bool = False) -> Iterator[Progress]:
    """A bar per scene and phase on a terminal; elsewhere nothing, or with ``verbose`` a plain line per phase."""
    if sys.stderr.isatty():
        from vitrail.commands.progress_bar import progress_bar

        with progress_bar(f"{scenes} scenes" if scenes > 1 else "scene") as show:
            yield show
        return
    seen: set[str] = set()

    def say(phase: str, done: float, total: float) -> None:
        if verbose and phase not in seen:
            seen.add(phase)
            typer.echo(phase, err=True)

    yield say
