"""From a first image to a regression: bless, compare against what was stored, accept by decisions."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from tests.end_to_end.conftest import ROOT
from tests.end_to_end.test_command_line import vitrail

pytestmark = [pytest.mark.povray, pytest.mark.tracer, pytest.mark.slow]

CARD = ROOT / "scenes" / "calibration" / "grey_card_directional.yaml"


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A copy of one scene with thresholds, so that nothing of ours is touched."""
    (tmp_path / "references").mkdir()
    shutil.copy(ROOT / "references" / "thresholds.yaml", tmp_path / "references")
    shutil.copy(CARD, tmp_path / "card.yaml")
    return tmp_path


def test_a_reference_is_made_kept_and_held_against(project: Path) -> None:
    scene = project / "card.yaml"
    without = vitrail("compare", scene, "--against", "stored", "--out", project / "out")
    assert without.returncode == 2 and "there is no stored reference" in without.stderr
    refused = vitrail("bless", scene, "--quality", "draft")
    assert refused.returncode == 2 and "needs its reason" in refused.stderr
    shown = vitrail("bless", scene, "--because", "d E / pi", "--quality", "draft", "--dry-run")
    assert shown.returncode == 0 and not (project / "references" / "card").exists()
    blessed = vitrail("bless", scene, "--because", "d E / pi", "--quality", "draft")
    assert blessed.returncode == 0 and "accepted:" in blessed.stdout
    again = vitrail("bless", scene, "--because", "again", "--quality", "draft", "--missing-only")
    assert "nothing to accept" in again.stdout
    image = project / "references" / "card" / "reference.exr"
    image.unlink()
    restored = vitrail("bless", scene, "--again")
    assert restored.returncode == 0 and "the same pixels as were accepted" in restored.stdout, restored.stderr
    assert image.is_file() and '"d E / pi"' in image.with_name("provenance.yaml").read_text()
    done = vitrail("compare", scene, "--against", "stored", "--out", project / "out", "--format", "junit")
    assert done.returncode == 0 and 'failures="0"' in done.stdout
    scene.write_text(scene.read_text().replace("0.18", "0.19"))
    changed = vitrail("compare", scene, "--against", "stored", "--out", project / "out")
    assert changed.returncode == 2 and "bless again" in changed.stderr


def test_a_recipe_that_gives_other_pixels_needs_a_new_reason(project: Path) -> None:
    scene = project / "card.yaml"
    assert vitrail("bless", scene, "--because", "d E / pi", "--quality", "draft").returncode == 0
    provenance = project / "references" / "card" / "provenance.yaml"
    accepted = provenance.read_text()
    provenance.write_text(re.sub(r'content: "\w{8}', 'content: "00000000', accepted))
    refused = vitrail("bless", scene, "--again")
    assert refused.returncode == 2 and "gives other pixels now" in refused.stderr
    assert vitrail("bless", scene, "--again", "--because", "a new compiler").returncode == 0
    assert provenance.read_text() == accepted.replace("d E / pi", "a new compiler")


def test_decisions_of_a_reader_are_applied(project: Path) -> None:
    scene, out = project / "card.yaml", project / "out"
    assert vitrail("compare", scene, "--against", "truth", "--out", out, "--quality", "draft").returncode in (0, 5)
    (image,) = json.loads((out / "results.json").read_text())["scenes"][0]["images"]
    decisions = {
        "vitrail_decisions": 1,
        "folder": str(out),
        "run": "",
        "decisions": [{"scene": "card", "decision": "accept", "because": "looked at it", "content": image["content"]}],
    }
    path = project / "decisions.json"
    path.write_text(json.dumps(decisions))
    done = vitrail("bless", "--from", path)
    assert done.returncode == 0, done.stderr
    assert 'because: "looked at it"' in (project / "references" / "card" / "provenance.yaml").read_text()
    again = vitrail("bless", scene, "--again", "--dry-run")
    assert again.returncode == 0 and "the same pixels as were accepted" in again.stdout, again.stderr
    path.write_text("{}")
    assert vitrail("bless", "--from", path).returncode == 2
