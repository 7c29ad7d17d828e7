"""Everything about a scene that needs two places of the file: the last step before a scene may be planned."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from vitrail.check.findings import Findings
from vitrail.check.lights import check_lights
from vitrail.check.materials import check_materials
from vitrail.check.meshes import check_meshes
from vitrail.check.shapes import check_shapes
from vitrail.check.sizes import check_sizes
from vitrail.check.solids import check_solids
from vitrail.check.views import check_views
from vitrail.scene.diagnostic import Diagnostic, SceneErrors, Severity
from vitrail.scene.load import Loaded, load, load_text


@dataclass(frozen=True)
class CheckResult:
    """The scene, when it could be built at all, and everything found, in the order of the file."""

    loaded: Loaded | None
    diagnostics: tuple[Diagnostic, ...]

    @property
    def errors(self) -> tuple[Diagnostic, ...]:
        return tuple(each for each in self.diagnostics if each.severity is Severity.ERROR)

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        return tuple(each for each in self.diagnostics if each.severity is Severity.WARNING)

    @property
    def is_valid(self) -> bool:
        return self.loaded is not None and not self.errors

    def scene_or_raise(self) -> Loaded:
        """The loaded scene; raises SceneErrors when anything is wrong with it."""
        if self.loaded is None or self.errors:
            raise SceneErrors(self.errors)
        return self.loaded


def check(loaded: Loaded) -> list[Diagnostic]:
    """All errors and warnings about a scene whose types are right, in the order of the file.

    Reads the meshes and the images of skies that the scene names.
    """
    findings = Findings(loaded)
    check_sizes(findings)
    check_materials(findings)
    check_shapes(findings)
    check_meshes(findings)
    check_solids(findings)
    check_lights(findings)
    check_views(findings)
    return sorted(set(findings.diagnostics), key=lambda each: each.order)


def check_file(path: str | Path) -> CheckResult:
    """Load and check a scene file; never raises for what the file says, and writes nothing."""
    return _checked(lambda: load(path))


def check_text(text: str, name: str | Path = "scene.yaml") -> CheckResult:
    """Load and check a scene given as text; see ``load_text``."""
    return _checked(lambda: load_text(text, name))


def _checked(read: Callable[[], Loaded]) -> CheckResult:
    try:
        loaded = read()
    except SceneErrors as errors:
        return CheckResult(None, errors.diagnostics)
    return CheckResult(loaded, tuple(check(loaded)))
