"""``python -m tests.fuzz --count 10000 --seed 1``: as many mutated meshes and skies; ends with 1 for a defect.

``--kills 200`` kills ``vitrail render`` so often instead.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from pathlib import Path

from tests.fuzz.kills import kill_often
from tests.fuzz.mutations import good_meshes, good_skies
from tests.fuzz.readers import DEFECTS, mesh_reader, run, sky_reader

SCENE = Path(__file__).parents[1] / "golden" / "plain.json"


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--count", type=int, default=1000, help="mutations of each kind of file")
    parser.add_argument("--seed", type=int, default=1, help="seed of the first mutation")
    parser.add_argument("--kills", type=int, default=0, help="kill a rendering so often instead")
    given = parser.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="vitrail-fuzz-"))
    if given.kills:
        wrong = kill_often(given.kills, given.seed, folder)
        print("\n".join([*wrong, f"{given.kills} kills, {len(wrong)} defects"]))
        return 1 if wrong else 0
    defects = 0
    for what, good, reader in (
        ("meshes", good_meshes(), mesh_reader),
        ("skies", good_skies(folder), sky_reader),
    ):
        found = run(given.count, given.seed, good, reader(json.loads(SCENE.read_text())), folder)
        defects += sum(found[each] for each in DEFECTS)
        print(f"{given.count} mutated {what}: " + ", ".join(f"{count} {each}" for each, count in found.most_common()))
    print(f"{defects} defects" + (f", kept in {folder}" if defects else ""))
    return 1 if defects else 0


if __name__ == "__main__":
    raise SystemExit(main())
