"""Renderings kept by content: the same input in the same engine is rendered once."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Callable, Iterable
from pathlib import Path

from vitrail.base.scratch import scratch_folder
from vitrail.engines.base import Rendering

RECORD = "record.json"


def content_key(engine: str, version: str, texts: Iterable[str]) -> str:
    """SHA-256 (hex) of everything that decides an image; ``texts`` are the lowered scene and the settings as text."""
    digest = hashlib.sha256()
    for part in (engine, version, *texts):
        _feed(digest, part.encode())
    return digest.hexdigest()


class Cache:
    """A folder of renderings by key. Several programs may use it at once: an entry appears whole or not at all."""

    def __init__(self, root: Path) -> None:
        self.root = root

    def folder(self, key: str) -> Path:
        return self.root / key[:2] / key

    def find(self, key: str) -> Rendering | None:
        """What is kept under a key, or None."""
        folder = self.folder(key)
        try:
            kept = json.loads((folder / RECORD).read_text(encoding="utf-8"))
            image, views = folder / kept["image"], {name: folder / file for name, file in kept["views"].items()}
            is_whole = all(file.is_file() for file in (image, *views.values()))
            return Rendering(image, kept["record"], views) if is_whole else None
        except (OSError, ValueError, KeyError, AttributeError):
            return None

    def rendered(self, key: str, render: Callable[[Path], Rendering]) -> Rendering:
        """What is kept under ``key``; else ``render`` into a new folder, and keep that unless it was interrupted.

        An interrupted rendering comes back from the folder where it was made, which stays.
        """
        kept = self.find(key)
        if kept is not None:
            return kept
        self.root.mkdir(parents=True, exist_ok=True)
        work = scratch_folder(".work-", self.root)
        try:
            made = render(work)
        except BaseException:
            shutil.rmtree(work, ignore_errors=True)
            raise
        return made if made.interrupted else self._keep(key, work, made)

    def _keep(self, key: str, work: Path, made: Rendering) -> Rendering:
        """Move a finished folder to its place; if somebody else was faster, theirs stays."""
        views = {name: file.name for name, file in made.views.items()}
        record = {"image": made.image_path.name, "record": made.record, "views": views}
        (work / RECORD).write_text(json.dumps(record), encoding="utf-8")
        folder = self.folder(key)
        folder.parent.mkdir(parents=True, exist_ok=True)
        try:
            os.rename(work, folder)
        except OSError:
            if self.find(key) is None:
                shutil.rmtree(folder, ignore_errors=True)
                os.rename(work, folder)
            else:
                shutil.rmtree(work, ignore_errors=True)
        found = self.find(key)
        assert found is not None
        return found


def _feed(digest: hashlib._Hash, data: bytes) -> None:
    """One part, with its length before it, so that parts cannot run into each other."""
    digest.update(len(data).to_bytes(8, "little"))
    digest.update(data)
