"""What a verb loads before it begins: a library that takes long to load must be wanted by what the verb does."""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.slow

HEAVY = (
    "scipy.stats",
    "scipy.signal",
    "scipy.spatial",
    "skimage",
    "OpenImageIO",
    "flip_evaluator",
    "plyfile",
    "jinja2",
)


def loaded_by(code: str) -> set[str]:
    """The heavy libraries that a fresh Python has loaded after ``code``."""
    asked = f"{code}\nimport sys\nprint('\\nloaded', *(each for each in {HEAVY!r} if each in sys.modules))"
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, check=True)
    return set(done.stdout.splitlines()[-1].split()[1:])


@pytest.mark.parametrize("verb", [["--help"], ["check", "scenes/calibration/ball_lens.yaml"]])
def test_a_verb_that_renders_nothing_loads_nothing_heavy(verb):
    run = "from vitrail.commands.app import app\nimport sys\nsys.argv[1:] = VERB\ntry: app()\nexcept SystemExit: pass"
    assert loaded_by(run.replace("VERB", repr(verb))) == set()


def test_rendering_by_the_tracer_loads_nothing_heavy():
    imports = (
        "import vitrail.commands.render\n"
        "from vitrail.engines.installed import engine_named\n"
        "from pathlib import Path\n"
        "from vitrail.base.engine_name import EngineName\n"
        "from vitrail.pipeline.job import prepare\n"
        "from vitrail.pipeline.render_image import render_image\n"
        "from vitrail.scene.load import load\n"
        "engine_named(EngineName.TRACER)\n"
        "prepare(load(Path('scenes/calibration/ball_lens.yaml'))).lowered(EngineName.TRACER)"
    )
    assert loaded_by(imports) == set()


def test_comparing_loads_no_statistics():
    assert not loaded_by("import vitrail.pipeline.compare") & {"scipy.stats", "scipy.signal", "plyfile"}
