"""What is kept beside the image after every pass, so that another sitting goes on to the same bits.

One uncompressed .npz file: the sums as they are in memory, and a header in JSON.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np

from vitrail.base.whole_file import whole_file
from vitrail.judge.half_error import Scatter
from vitrail.pipeline.passes.sums import Sums

FORMAT = 1
SUFFIX = ".passes.npz"


class CheckpointError(Exception):
    """A checkpoint is missing, damaged, or of another image; the message names the file and what to do."""


@dataclass(frozen=True)
class Identity:
    """What decides the bits of every pass. ``key`` is the content: the lowered scene, the files it names, the build."""

    key: str
    scene_hash: str
    settings: Mapping[str, Any]
    build: str


@dataclass(frozen=True)
class Checkpoint:
    """The finished passes: their sums, the run record of all of them, and one entry a pass of the lists.

    ``metadata`` is that of the first pass's image. ``next_look`` is when the error is to be measured again for the
    ``targets`` it was measured for.
    """

    identity: Identity
    sums: Sums = Sums()
    record: Mapping[str, Any] = field(default_factory=dict)
    metadata: Mapping[str, Any] = field(default_factory=dict)
    scatter: Scatter = Scatter()
    noise: tuple[float, ...] = ()
    cpu_s: tuple[float, ...] = ()
    targets: tuple[str, ...] = ()
    next_look: int = 1


def checkpoint_path(image: Path) -> Path:
    return image.with_suffix(SUFFIX)


def write_checkpoint(path: Path, state: Checkpoint) -> None:
    """Replace the checkpoint; raises OSError."""
    header = {
        "vitrail_passes": FORMAT,
        "count": state.sums.count,
        "names": list(state.sums.arrays),
        **{name: value for name, value in vars(state).items() if name not in ("sums", "scatter", "identity")},
        "scatter": asdict(state.scatter),
        "identity": asdict(state.identity),
    }
    arrays = {str(place): array for place, array in enumerate(state.sums.arrays.values())}
    arrays["header"] = np.frombuffer(json.dumps(header).encode(), np.uint8)
    with whole_file(path, durable=True) as partial:
        np.savez(partial, **arrays)  # type: ignore[arg-type]  # its stub takes any name for allow_pickle


def read_checkpoint(path: Path, wanted: Identity) -> Checkpoint:
    """The finished passes of the image that is wanted. Raises CheckpointError."""
    if not path.is_file():
        raise CheckpointError(
            f"{path}: there is no checkpoint to resume; leave --resume out to begin, or correct --out"
        )
    try:
        with np.load(path, allow_pickle=False) as stored:
            header = json.loads(stored["header"].tobytes())
            arrays = {name: stored[str(place)] for place, name in enumerate(header["names"])}
        found = Identity(**header["identity"])
        rest = {name: _frozen(header[name]) for name in Checkpoint.__dataclass_fields__ if name in header}
        if header["vitrail_passes"] != FORMAT:
            raise ValueError(f"version {header['vitrail_passes']}, not {FORMAT}")
        sums, scatter = Sums(int(header["count"]), arrays), Scatter(**header["scatter"])
        state = Checkpoint(**{**rest, "identity": found, "sums": sums, "scatter": scatter})
    except (ValueError, KeyError, TypeError, EOFError, OSError, BadZipFile) as damage:
        raise CheckpointError(
            f"{path}: is no checkpoint that can be read ({damage}); leave --resume out to begin anew"
        ) from None
    if found.key != wanted.key:
        raise CheckpointError(f"{path}: holds passes {_foreign(found, wanted)}, or leave --resume out to begin anew")
    return state


def _frozen(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _foreign(found: Identity, wanted: Identity) -> str:
    """Whose passes they are, and how to go on with them."""
    if found.scene_hash != wanted.scene_hash:
        return "of another scene; name the scene it was begun with"
    names = [*dict.fromkeys([*found.settings, *wanted.settings])]
    other = [name for name in names if found.settings.get(name) != wanted.settings.get(name)]
    if other:
        there = ", ".join(f"{name} {found.settings.get(name)} and not {wanted.settings.get(name)}" for name in other)
        return f"with other settings ({there}); give the settings it was begun with"
    if found.build != wanted.build:
        return f"of another tracer ({found.build}, not {wanted.build}); use the tracer it was begun with"
    return "whose meshes, images of the sky or plan were others; bring those files back"
