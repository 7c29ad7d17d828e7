"""Exit codes: 0 agrees, 1 deviates, 2 usage or scene, 3 not translatable, 4 engine failed, 5 in doubt, 70 a defect."""

from __future__ import annotations

from vitrail.judge.comparison import Verdict
from vitrail.judge.exit_code import of_run, of_scene
from vitrail.judge.records import Status


def test_every_end_of_a_scene_has_its_code() -> None:
    judged = [of_scene(Status.JUDGED, verdict) for verdict in (Verdict.AGREES, Verdict.DEVIATES, Verdict.INCONCLUSIVE)]
    assert judged == [0, 1, 5]
    assert of_scene(Status.JUDGED, None) == 2, "a scene without one comparison has judged nothing"
    ends = (Status.SCENE_ERROR, Status.GATE_FAILED, Status.NOT_TRANSLATABLE, Status.ENGINE_FAILED, Status.INTERRUPTED)
    assert [of_scene(status, None) for status in ends] == [2, 2, 3, 4, 130]
    assert of_scene(Status.DEFECT, None) == 70


def test_the_worst_scene_gives_the_code_of_the_run() -> None:
    assert of_run([0, 5, 1]) == 1, "a deviation outranks doubt"
    assert of_run([0, 5]) == 5
    assert of_run([1, 4, 0]) == 4, "missing evidence outranks a verdict"
    assert of_run([1, 70, 4, 2]) == 70, "a defect of the program outranks what it says of scenes"
    assert of_run([0, 0]) == 0
    assert of_run([]) == 2, "no scene collected is a failure"
