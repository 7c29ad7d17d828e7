"""The smallest renderer that Vitrail will judge: faces that glow or scatter, a sun, a lamp; no shadows, no glass.

    vitrail emit tracer SCENE.yaml --out DIR
    python docs/adapters/numpy_renderer.py DIR/scene.json IMAGE.exr

It is here to be read: every convention that another renderer must translate is one line of it.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio

GRID = 4
"""Samples along each edge of a pixel; their mean is the pixel (a box filter, no neighbours)."""


def render(scene: dict[str, Any]) -> np.ndarray:
    """Radiance (height, width, 3), W sr^-1 m^-2, row 0 on top."""
    width, height = scene["image"]["width"], scene["image"]["height"]
    step = (np.arange(GRID) + 0.5) / GRID
    column, row = (np.arange(width)[:, None] + step).ravel(), (np.arange(height)[:, None] + step).ravel()
    sx, sy = np.meshgrid(2 * column / width - 1, 1 - 2 * row / height)
    radiance = shade(scene, *rays(scene["camera"], sx[..., None], sy[..., None]))
    return radiance.reshape(height, GRID, width, GRID, 3).mean(axis=(1, 3))


def rays(camera: dict[str, Any], sx: np.ndarray, sy: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Origin and direction of the rays through (sx, sy) in [-1, 1], x to the right and y upwards."""
    right, up, forward, position = (np.array(camera[key]) for key in ("right", "up", "forward", "position"))
    across = sx * camera["half_width"] * right + sy * camera["half_height"] * up
    if camera["kind"] == "orthographic":
        return position + across, np.broadcast_to(forward, across.shape)
    return np.broadcast_to(position, across.shape), forward + across


def shade(scene: dict[str, Any], origin: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """What the nearest face sends along each ray: its emission, and d E / pi of the light on it."""
    nearest, radiance = np.full(origin.shape[:-1], np.inf), np.zeros(origin.shape)
    for each in scene["objects"]:
        centre, edges, normal = face(each["shape"])
        with np.errstate(divide="ignore"):
            distance = ((centre - origin) @ normal) / (direction @ normal)
        point = origin + distance[..., None] * direction
        seen = (distance > 0) & (distance < nearest)
        for edge in edges:
            seen &= np.abs((point - centre) @ edge) <= edge @ edge
        nearest[seen] = distance[seen]
        material = scene["materials"][each["material"]]
        facing = normal * -np.sign(direction @ normal)[..., None]
        lit = irradiance(scene["lights"], point[seen], facing[seen])
        radiance[seen] = np.array(material["emission"]) + np.array(material["diffuse"]) * lit / np.pi
    return radiance


def face(shape: dict[str, Any]) -> tuple[np.ndarray, list[np.ndarray], np.ndarray]:
    """A point of a face, the half edges that bound it (a plane has none), and its unit normal."""
    if shape["kind"] == "plane":
        return np.array(shape["point"]), [], np.array(shape["normal"])
    u, v = np.array(shape["u"]), np.array(shape["v"])
    return np.array(shape["center"]), [u, v], np.cross(u, v) / np.linalg.norm(np.cross(u, v))


def irradiance(lights: list[dict[str, Any]], point: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """W m^-2 on the side that is seen: a sun by its irradiance across the beam, a lamp by its intensity."""
    found = np.zeros(point.shape)
    for light in lights:
        if light["kind"] == "directional":
            towards = np.broadcast_to(-np.array(light["direction"]), point.shape)
            strength = np.broadcast_to(light["irradiance"], point.shape)
        else:
            away = np.array(light["position"]) - point
            squared = np.sum(away**2, axis=-1, keepdims=True)
            towards, strength = away / np.sqrt(squared), np.array(light["intensity"]) / squared
        found += strength * np.maximum(np.sum(towards * normal, axis=-1, keepdims=True), 0)
    return found


def write(path: str, radiance: np.ndarray) -> None:
    """One part, channels R, G, B, float, linear. OpenImageIO raises nothing: ask it whether it wrote."""
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    image = oiio.ImageBuf(np.ascontiguousarray(radiance, dtype=np.float32))
    image.set_write_format(oiio.FLOAT)
    if not image.write(path):
        sys.exit(f"{path}: {image.geterror()}")


if __name__ == "__main__":
    write(sys.argv[2], render(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))))
