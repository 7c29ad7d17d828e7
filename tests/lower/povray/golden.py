"""The scene texts that are kept word for word, and how to accept a change of them.

``python -m tests.lower.povray.golden`` writes what the back end emits now into ``tests/golden``; read the difference
before you commit it.
"""

from __future__ import annotations

from pathlib import Path

from vitrail.geometry.world import World
from vitrail.lower.povray import lower_povray
from vitrail.plan.analyse import analyse
from vitrail.plan.budget import settings_for
from vitrail.scene.load import load

ROOT = Path(__file__).parents[3]
GOLDEN = ROOT / "tests" / "golden"

SCENES = {
    "grey_card_directional": "scenes/calibration/grey_card_directional.yaml",
    "grey_card_point": "scenes/calibration/grey_card_point.yaml",
    "slab_tilted": "scenes/calibration/slab_tilted.yaml",
    "tinted_pane_projected": "scenes/calibration/tinted_pane_projected.yaml",
    "ball_lens": "scenes/calibration/ball_lens.yaml",
    "figure_1": "scenes/paper/figure_1.yaml",
}


def emitted(name: str) -> dict[str, str]:
    """File name to text of the first run of each half, with settings of its own."""
    loaded = load(ROOT / SCENES[name])
    world = World.of(loaded)
    plan = analyse(world)
    chosen: dict[str, object] = {"samples": 4, "gather_radius_m": 0.03125}
    if settings_for(world, plan).photons:
        chosen["photons"] = 100_000
    translated = lower_povray(world, plan, settings_for(world, plan, **chosen))
    first = {run.half: run for run in reversed(translated.runs)}
    return {f"{name}.{file}": text for run in first.values() for file, text in run.texts.items()}


def main() -> None:
    for name in SCENES:
        for file, text in emitted(name).items():
            (GOLDEN / file).write_text(text, encoding="ascii")


if __name__ == "__main__":
    main()
