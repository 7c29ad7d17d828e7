"""The scenes of one comparison: what each has come to so far, and what its budget has left."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.judge.comparison import Verdict
from vitrail.judge.purchase import PriceScore, price_score
from vitrail.judge.records import Results, Run, SceneResult, write_results
from vitrail.judge.references import read_scene_truth, references_folder
from vitrail.judge.stored import read_stored
from vitrail.judge.thresholds import Thresholds, thresholds_of
from vitrail.pipeline.ablate import deviates_between_engines
from vitrail.pipeline.about_run import about_run
from vitrail.pipeline.judge import judge, judge_scene
from vitrail.pipeline.look_again import priced, with_look
from vitrail.pipeline.more_samples import offer, purchases
from vitrail.pipeline.own_defect import defective, if_own_defect
from vitrail.pipeline.prices import paid_s
from vitrail.pipeline.request import Request
from vitrail.pipeline.scene_run import SceneRun, SceneTask
from vitrail.scene.load import Loaded
from vitrail.scene.print import scene_hash


@dataclass
class Suite:
    """``scenes`` by name, in their order; ``runs`` those that were looked at, ``last`` as they were looked at last.

    ``left_s`` CPU seconds are left for all of them together.
    """

    scenes: Mapping[str, Loaded]
    request: Request
    about: Run
    begun_s: float = field(default_factory=time.monotonic)
    runs: dict[str, SceneRun] = field(default_factory=dict)
    last: dict[str, SceneResult] = field(default_factory=dict)
    left_s: float = 0.0
    interrupted: bool = False

    @classmethod
    def begin(cls, scenes: Sequence[Loaded], request: Request) -> Suite:
        """A comparison of scenes none of which has run yet. Raises ReferencesError, ThresholdError and ImageError."""
        about = about_run(request.command, request.threads)
        check_references(scenes, request)
        request.out.mkdir(parents=True, exist_ok=True)
        names = scene_names([loaded.path for loaded in scenes])
        return cls(dict(zip(names, scenes, strict=True)), request, about, left_s=request.suite_budget_s(len(scenes)))

    def tasks(self) -> list[SceneTask]:
        """Every scene, as it was asked for."""
        return [SceneTask(name, loaded, self.request) for name, loaded in self.scenes.items()]

    def more_samples(self) -> list[SceneTask]:
        """Another look at the scenes in doubt, at the views that the budget pays for, the cheapest decisions first."""
        doubtful = [self._priced(scene) for scene in self.results().scenes if scene.verdict is Verdict.INCONCLUSIVE]
        fixed = [scene.name for scene in doubtful if self._is_fixed(scene.name)]
        bought = purchases(doubtful, max(self.left_s, 0.0), fixed)
        return [
            SceneTask(name, self.scenes[name], self.request, purchase, 2 + len(self.runs[name].record.purchases))
            for name, purchase in bought.items()
        ]

    def deviating(self) -> list[SceneResult]:
        """The judged scenes whose engines deviate from each other."""
        scenes = self.results().scenes
        return [scene for scene in scenes if any(map(deviates_between_engines, scene.observations))]

    def keep(self, task: SceneTask, run: SceneRun) -> None:
        """Remember what a scene came to, and write it down with all others.

        The first look is what was asked for; only those after it are paid from the budget.
        """
        if task.purchase is not None:
            self.left_s -= paid_s(run.record.engines)
            if run.record.engines:
                self.last[task.name] = run.record
            run = with_look(self.runs[task.name], run, task.purchase)
        self.runs[task.name] = run
        self.results()

    def keep_search(self, name: str, run: SceneRun) -> None:
        """Remember what was tried to find where the engines deviate, which is paid from the budget too."""
        self.left_s -= sum(each.cpu_s for each in run.search.ablated)
        self.runs[name] = run

    def results(self) -> Results:
        """All verdicts so far, written to ``results.json``; a scene in doubt has what it would cost to decide it."""
        spent = {"wall_s": round(time.monotonic() - self.begun_s, 3), "interrupted": self.interrupted}
        results = judge(
            [self.runs[name] for name in self.scenes if name in self.runs],
            changed(self.about, **spent),
            looks=1 + self.request.rounds,
            judge_one=self._judged,
        )
        results = changed(results, scenes=tuple(map(self._with_price, results.scenes)), prices=self._prices())
        write_results(results, self.request.out / "results.json")
        return results

    def _prices(self) -> PriceScore | None:
        """How well the prices of this run were foreseen, once something was bought."""
        bought = [purchase for run in self.runs.values() for purchase in run.record.purchases]
        return price_score(bought) if bought else None

    def _judged(self, run: SceneRun, rules: Thresholds, level: float) -> SceneResult:
        name = run.record.name
        return if_own_defect(
            lambda: judge_scene(run, rules, level),
            lambda error: defective(SceneTask(name, self.scenes[name], self.request), error),
        )

    def _with_price(self, scene: SceneResult) -> SceneResult:
        budget_s = self.request.suite_budget_s(len(self.scenes))
        is_fixed = self._is_fixed(scene.name)
        deal = offer(self._priced(scene), max(self.left_s, 0.0), budget_s, fixed_samples=is_fixed)
        return changed(scene, more_samples=deal)

    def _priced(self, scene: SceneResult) -> SceneResult:
        """The scene with what its views cost when they were looked at last."""
        return priced(scene, self.last[scene.name]) if scene.name in self.last else scene

    def _is_fixed(self, name: str) -> bool:
        """Whether a scene is about its samples, which are then never raised."""
        return not self.request.views and self.scenes[name].scene.image.samples is not None


def check_references(scenes: Sequence[Loaded], request: Request) -> None:
    """Refuse unusable references before an hour of rendering, not after it."""
    for loaded in scenes:
        folder = references_folder(loaded.path, request.references)
        thresholds_of(folder)
        read_scene_truth(folder, loaded.path.stem, loaded.scene)
        if "stored" in request.against:
            read_stored(folder, loaded.path.stem, scene_hash(loaded.scene))


def scene_names(paths: Sequence[Path]) -> list[str]:
    """One folder name a scene: the stem of its file, with its folder before it where two would be the same."""
    stems = [path.stem for path in paths]
    names = [
        path.stem if stems.count(path.stem) == 1 else f"{path.resolve().parent.name}-{path.stem}" for path in paths
    ]
    return [name if names.index(name) == place else f"{name}-{place}" for place, name in enumerate(names)]
