"""Which solver of caustics is best, scene by scene: CPU seconds and error of each against eight times the photons.

    .venv/bin/python benchmarks/solvers.py scenes/paper/*.yaml scenes/calibration/*.yaml --out out/solvers.json

The error is that of the layer `caustic`: sum of |difference| over sum of the reference, over the whole picture. Two
references, each of four times the photons by `light_bins`, have seeds of their own; their difference says how well the
reference is known. `score` is CPU seconds times the square of the error: the seconds to a given error where noise
leads.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vitrail.base.engine_name import EngineName
from vitrail.engines.tracer import find_tracer
from vitrail.images.exr import read_image
from vitrail.pipeline.job import Job, prepare
from vitrail.plan.settings import Quality, Solver
from vitrail.scene.load import Loaded, load

Image = NDArray[np.float64]

RAYS_PER_PHOTON = {Solver.PHOTON_MAP: 1.0, Solver.LIGHT_BINS: 1.0, Solver.BEAMS: 0.1}
"""A beam costs about as much as ten photons."""


LINE = (
    "{scene:22} {quality:7} {solver:11} {taken:11} {cpu_s:7.2f} s {error:8.4f} of which reference {reference_noise:.4f}"
)


@dataclass(frozen=True)
class Measured:
    """One rendering: CPU seconds of the tracer, its caustic layer, and its run record."""

    cpu_s: float
    caustic: Image
    record: dict[str, Any]


def rendered(job: Job, folder: Path) -> Measured:
    """Render a job on one thread."""
    scene, image, run = folder / "scene.json", folder / "image.exr", folder / "run.json"
    scene.write_text(json.dumps(job.lowered(EngineName.TRACER)))
    command = [find_tracer(), "render", scene, "--out", image, "--record", run, "--threads", "1"]
    subprocess.run([str(each) for each in command], check=True, capture_output=True)
    record = json.loads(run.read_text())
    return Measured(record["cpu_s"]["total"], np.asarray(read_image(image).layers["caustic"], float), record)


def error(image: Image, reference: Image) -> float:
    """Sum of |difference| over sum."""
    return float(np.abs(image - reference).sum() / reference.sum())


def rows_of(loaded: Loaded, quality: Quality, folder: Path) -> list[dict[str, Any]]:
    """One row a solver; none for a scene without a caustic."""
    usual = prepare(loaded, quality)
    if usual.settings.photons == 0:
        return []

    def run(solver: Solver, times: float, seed: int) -> Measured:
        photons = max(1000, round(usual.settings.photons * times))
        return rendered(prepare(loaded, quality, {"solver": solver, "photons": photons, "seed": seed}), folder)

    a, b = (run(Solver.LIGHT_BINS, 4, seed).caustic for seed in (11, 12))
    reference = (a + b) / 2
    if not reference.sum() > 0:
        return []
    rows = []
    for solver in (*RAYS_PER_PHOTON, Solver.AUTO):
        made = run(solver, RAYS_PER_PHOTON.get(solver, 1), 1)
        wrong = error(made.caustic, reference)
        rows.append(
            {
                "scene": loaded.path.stem,
                "quality": quality,
                "solver": solver,
                "taken": made.record["settings"]["solver"],
                "cpu_s": made.cpu_s,
                "error": wrong,
                "score": made.cpu_s * wrong**2,
                "reference_noise": error(a, b) / 2,
                "beams": made.record.get("beams"),
                "emitted": made.record["ledger"]["emitted"],
            }
        )
    return rows


def main() -> None:
    """Measure, print a line for each rendering, and write all rows."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", type=Path)
    parser.add_argument("--quality", nargs="+", type=Quality, default=[Quality.DRAFT, Quality.NORMAL])
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    rows: list[dict[str, Any]] = []
    with tempfile.TemporaryDirectory(prefix="vitrail-solvers-") as work:
        for path in options.scenes:
            for quality in options.quality:
                found = rows_of(load(path), quality, Path(work))
                for row in found:
                    print(
                        "{scene:22} {quality:7} {solver:11} {taken:11} {cpu_s:7.2f} s {error:8.4f}".format(**row),
                        flush=True,
                    )
                rows += found
                options.out.write_text(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()
