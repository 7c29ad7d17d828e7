"""Run a verb as a user would, inside this process, and see what it said and did."""

from __future__ import annotations

import sys
from pathlib import Path

from typer.testing import CliRunner, Result

from vitrail.commands.app import app

ROOT = Path(__file__).parents[2]
SCENE = ROOT / "tests" / "golden" / "plain.yaml"

TRACER = f"""#!{sys.executable}
import sys
value_of = lambda option: sys.argv[sys.argv.index(option) + 1]
open(value_of("--out"), "w").write("image")
open(value_of("--record"), "w").write('{{"vitrail_run": 1, "interrupted": %s}}')
"""


def run(*arguments: object) -> Result:
    return CliRunner().invoke(app, [str(argument) for argument in arguments], prog_name="vitrail")


def files_in(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def fake_tracer(folder: Path, *, interrupted: bool = False) -> Path:
    """A tracer that writes a word instead of an image."""
    program = folder / "vitrail-tracer"
    program.write_text(TRACER % ("true" if interrupted else "false"), encoding="utf-8")
    program.chmod(0o755)
    return program
