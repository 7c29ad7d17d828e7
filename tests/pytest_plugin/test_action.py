"""The composite action calls what exists: its make target, its verb, its options, its choices."""

from __future__ import annotations

import re
from pathlib import Path

from ruamel.yaml import YAML

from vitrail.commands.app import load_verb
from vitrail.commands.compare import Against

ROOT = Path(__file__).parents[2]


def test_the_action_calls_what_exists() -> None:
    action = YAML(typ="safe").load((ROOT / "action.yml").read_text())
    steps = action["runs"]["steps"]
    assert all(step["shell"] == "bash" for step in steps), "a composite step without a shell is refused"
    text = "\n".join(step["run"] for step in steps)
    options = {name for parameter in load_verb("compare").params for name in parameter.opts}
    used = set(re.findall(r"--[a-z-]+", text))
    assert used and used <= options
    assert action["inputs"]["against"]["default"] in set(Against)
    target = re.search(r"make -C \S+ (\w+)", text)
    assert target is not None and re.search(rf"^{target[1]}:", (ROOT / "Makefile").read_text(), re.MULTILINE)
    given = {name for step in steps for name in re.findall(r"inputs\.(\w+)", str(step.get("env", "")))}
    assert given == set(action["inputs"])


def test_the_example_in_the_docs_gives_inputs_that_exist() -> None:
    action = YAML(typ="safe").load((ROOT / "action.yml").read_text())
    example = re.search(r"```yaml\n(.*?)```", (ROOT / "docs" / "use-in-ci.md").read_text(), re.DOTALL)
    assert example is not None
    workflow = YAML(typ="safe").load(example[1])
    (step,) = [each for each in workflow["jobs"]["compare"]["steps"] if "vitrail/vitrail" in each.get("uses", "")]
    assert set(step["with"]) <= set(action["inputs"])
