"""The picture that was made for the observations of one patch, as ``results.json`` has it."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from vitrail.base.record import Record


class ViewImage(Record):
    """One side's picture of a view: linear radiance and display picture, relative to the folder of ``results.json``."""

    side: str
    exr: str
    png: str


class ViewRecord(Record):
    """The picture in which an observation was measured, where that is not the scene's own.

    ``fov_deg`` is that of a perspective camera, ``height_m`` that of an orthographic one. ``outline_px`` is the patch
    in this picture (pixels, row 0 on top). ``difference_picture`` is that of the first two sides.
    """

    name: str
    kind: Literal["perspective", "orthographic"]
    position: tuple[float, float, float]
    look_at: tuple[float, float, float]
    up: tuple[float, float, float]
    fov_deg: float | None = None
    height_m: float | None = None
    width: int = Field(ge=1)
    height: int = Field(ge=1)
    samples: int = Field(ge=1)
    outline_px: tuple[tuple[float, float], ...] = ()
    images: tuple[ViewImage, ...] = ()
    difference_picture: str = ""
