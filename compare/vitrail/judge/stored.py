"""Accepted images: ``references/<scene>/reference.exr`` with ``provenance.yaml``, small enough for git.

A stored image is our own older answer, the last in the order of truth. It holds radiance and two halves (its noise) as
half floats, and says in its provenance who made it, how, when and because of what. Its content is hashed over decoded
pixels, because two files of the same picture may differ in their headers.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from vitrail.base.whole_file import whole_file, write_whole
from vitrail.images.exr import ImageError, ImageLayers, read_image, write_image
from vitrail.judge.reference_files import ReferencesError, read_yaml

IMAGE, PROVENANCE = "reference.exr", "provenance.yaml"
FIELDS = ("scene_hash", "because", "engine", "version", "made", "quality", "settings", "content")


@dataclass(frozen=True)
class Provenance:
    """Where an accepted image comes from. ``content`` is the hash of its pixels, ``settings`` the recipe."""

    scene_hash: str
    because: str
    engine: str
    version: str
    made: str
    quality: str
    content: str
    settings: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Stored:
    """An accepted image with its provenance and what must be said about it."""

    image: ImageLayers
    provenance: Provenance
    path: Path

    def remarks(self, version: str) -> tuple[str, ...]:
        """What a reader must know: a reference made by another version is compared, but never silently."""
        made_by = self.provenance.version
        if made_by == version:
            return ()
        return (f"the stored reference was made by {self.provenance.engine} {made_by}, this is {version}",)


def read_stored(folder: Path, scene_name: str, scene_hash: str) -> Stored:
    """The accepted image of a scene. Raises ReferencesError when it is missing, changed, or of another scene."""
    place = folder / scene_name
    if not (place / IMAGE).is_file():
        raise ReferencesError(
            f'{place / IMAGE}: there is no stored reference; accept one with `vitrail bless SCENE --because "..."`'
        )
    provenance = read_provenance(folder, scene_name)
    try:
        image = read_image(place / IMAGE)
    except ImageError as error:
        raise ReferencesError(str(error)) from None
    if content_hash(image) != provenance.content:
        raise ReferencesError(
            f"{place / IMAGE}: its pixels are not those that were accepted; restore the file or bless again"
        )
    if provenance.scene_hash != scene_hash:
        raise ReferencesError(
            f"{place / IMAGE}: shows scene {provenance.scene_hash[:12]}, the scene is now {scene_hash[:12]};"
            " look at the change and bless again"
        )
    return Stored(image, provenance, place / IMAGE)


def write_stored(folder: Path, scene_name: str, image: ImageLayers, provenance: Provenance) -> Path:
    """Put an image in the place of the scene's reference; both files appear whole. Returns the image's path.

    ``provenance.content`` is computed here from the pixels as they are stored.
    """
    place = folder / scene_name
    with whole_file(place / IMAGE) as partial:
        write_image(
            partial,
            image.radiance,
            half_a=image.half_a,
            half_b=image.half_b,
            metadata={key: image.metadata[key] for key in sorted(image.metadata) if key.startswith("vitrail:")},
            pixel_type="half",
        )
        content = content_hash(read_image(partial))
        text = "".join(f"{key}: {json.dumps(value)}\n" for key, value in _ordered(provenance, content))
        write_whole(place / PROVENANCE, text)
    return place / IMAGE


def content_hash(image: ImageLayers) -> str:
    """SHA-256 (hex) of the pixels: radiance and halves, as float32, in order."""
    digest = hashlib.sha256()
    for array in (image.radiance, image.half_a, image.half_b):
        if array is not None:
            digest.update(str(array.shape).encode())
            digest.update(np.ascontiguousarray(array, dtype="<f4").tobytes())
    return digest.hexdigest()


def stored_content(image: ImageLayers) -> str:
    """The hash that an image will have once it is stored: its pixels rounded to half floats."""
    halves = (image.radiance, image.half_a, image.half_b)
    rounded = [None if array is None else array.astype(np.float32).astype(np.float16) for array in halves]
    return content_hash(replace(image, radiance=rounded[0], half_a=rounded[1], half_b=rounded[2]))  # type: ignore[arg-type]


def _ordered(provenance: Provenance, content: str) -> list[tuple[str, Any]]:
    """The fields in their fixed order, so that a change of one is one line of a diff."""
    values = {**vars(provenance), "content": content, "settings": dict(sorted(provenance.settings.items()))}
    return [(name, values[name]) for name in FIELDS]


def read_provenance(folder: Path, scene_name: str) -> Provenance:
    """Where a scene's reference comes from, and its recipe; the image need not be there. Raises ReferencesError."""
    path = folder / scene_name / PROVENANCE
    found = read_yaml(path)
    missing = [name for name in FIELDS if name not in found]
    unknown = [name for name in found if name not in FIELDS]
    if missing or unknown:
        raise ReferencesError(
            f"{path}: lacks {missing or 'nothing'} and has unknown {unknown or 'nothing'}; bless again"
        )
    return Provenance(**{name: found[name] for name in FIELDS})
