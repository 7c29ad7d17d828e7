"""The mesh that an object names, read once; only from a scene whose files have full paths."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from vitrail.base.changed import changed
from vitrail.geometry.mesh_file import MeshFileError, read_triangles
from vitrail.geometry.mesh_solid import MeshSolid
from vitrail.geometry.placement import Frame, Placed
from vitrail.scene.model import Mesh, Object, Scene


def with_full_paths(scene: Scene, folder: Path) -> Scene:
    """The scene with its meshes named by full paths, so that what asks for their shape can read them."""

    def full(item: Object) -> Object:
        if not isinstance(item.shape, Mesh):
            return item
        return changed(item, shape=changed(item.shape, file=str((folder / item.shape.file).resolve())))

    return scene.model_copy(update={"objects": tuple(full(item) for item in scene.objects)})


def moved(shape: Mesh, outwards_m: float) -> Mesh:
    """The same file with its faces moved along their normals by a translation."""
    copy = shape.model_copy()
    copy._moved_m += outwards_m
    return copy


def solid_of(placed: Placed) -> MeshSolid | None:
    """What a mesh encloses, where a translation has moved its faces too; None if it is not named by a full path.

    Raises MeshFileError for a file that cannot be read.
    """
    assert isinstance(placed.shape, Mesh)
    path = Path(placed.shape.file)
    if not path.is_absolute():
        return None
    try:
        stat = path.stat()
    except OSError as error:
        raise MeshFileError(f"it cannot be read ({error.strerror})") from None
    return _read(placed.shape, placed.shape._moved_m, placed.frame, stat.st_mtime_ns, stat.st_size)


@lru_cache(maxsize=64)
def _read(shape: Mesh, moved_m: float, frame: Frame, _changed: int, _size: int) -> MeshSolid:
    """Read again what was written again."""
    solid = MeshSolid(read_triangles(Path(shape.file), shape, frame))
    return MeshSolid(solid.moved(moved_m)) if moved_m else solid
