"""Mitsuba 3 as a third opinion: render a lowered scene with it, as two independent halves.

    pip install mitsuba
    vitrail emit tracer SCENE.yaml --out DIR
    python docs/adapters/mitsuba_renderer.py DIR/scene.json IMAGE.exr [--integrator ptracer --far-m 2] [--samples 256]

It knows what the conformance scenes and the referee's scenes need: rectangles, planes, spheres and boxes along the axes
that scatter, glow or are smooth Fresnel glass; suns and lamps. `path` sees through glass and finds no caustic of a
sun; `ptracer` finds the caustic and shows glass black. What it does not know it refuses. It runs in its own process,
because Mitsuba and OpenImageIO each bring libraries along; the EXR is written by Mitsuba itself.
"""

from __future__ import annotations

import argparse
import json
import math
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np


def translated(scene: dict[str, Any], far_m: float, samples: int, seed: int) -> dict[str, Any]:
    """The scene as a dictionary of Mitsuba; a part that cannot be said raises ValueError."""
    found: dict[str, Any] = {"type": "scene", "camera": sensor(scene, samples, seed)}
    for index, each in enumerate(scene["objects"]):
        found[f"object_{index}"] = shape(each["shape"], far_m) | surface(scene["materials"][each["material"]])
    for index, light in enumerate(scene["lights"]):
        found[f"light_{index}"] = emitter(light)
    return found


def sensor(scene: dict[str, Any], samples: int, seed: int) -> dict[str, Any]:
    """Mitsuba's x points to the left of the picture and its angle is the horizontal one; a box filter is a pixel."""
    camera, image = scene["camera"], scene["image"]
    position, forward, up = (np.array(camera[key]) for key in ("position", "forward", "up"))
    to_world = mi.ScalarTransform4f().look_at(position.tolist(), (position + forward).tolist(), up.tolist())
    film = {
        "type": "hdrfilm",
        "width": image["width"],
        "height": image["height"],
        "pixel_format": "rgb",
        "component_format": "float32",
        "rfilter": {"type": "box"},
    }
    common = {"film": film, "sampler": {"type": "independent", "sample_count": samples, "seed": seed}}
    if camera["kind"] == "orthographic":
        scaled = to_world @ mi.ScalarTransform4f().scale([camera["half_width"], camera["half_width"], 1])
        return {"type": "orthographic", "to_world": scaled, "near_clip": 1e-4, **common}
    angle = 2 * math.degrees(math.atan(camera["half_width"]))
    return {"type": "perspective", "fov": angle, "fov_axis": "x", "to_world": to_world, "near_clip": 1e-4, **common}


def shape(given: dict[str, Any], far_m: float) -> dict[str, Any]:
    """A shape of unit size and where it stands; a square of half edge ``far_m`` stands for an infinite plane."""
    match given["kind"]:
        case "sphere":
            return {"type": "sphere", "center": given["center"], "radius": given["radius"]}
        case "rectangle":
            u, v = np.array(given["u"]), np.array(given["v"])
            return {"type": "rectangle", "to_world": frame(u, v, np.cross(u, v), np.array(given["center"]))}
        case "plane":
            normal = np.array(given["normal"])
            u = np.cross(normal, [0.0, 0, 1] if abs(normal[0]) > 0.9 else [1.0, 0, 0])
            u /= np.linalg.norm(u)
            v = np.cross(normal, u)
            return {"type": "rectangle", "to_world": frame(far_m * u, far_m * v, normal, np.array(given["point"]))}
        case "box" if given["frame"]["identity"]:
            low, high = np.array(given["min"]), np.array(given["max"])
            edges = np.diag((high - low) / 2)
            return {"type": "cube", "to_world": frame(*edges, (low + high) / 2)}
    raise ValueError(f"shape {given['kind']}: not known here")


def frame(u: np.ndarray, v: np.ndarray, w: np.ndarray, origin: np.ndarray) -> Any:
    matrix = np.eye(4)
    matrix[:3, 0], matrix[:3, 1], matrix[:3, 2], matrix[:3, 3] = u, v, w, origin
    return mi.ScalarTransform4f(matrix.tolist())


def surface(material: dict[str, Any]) -> dict[str, Any]:
    """Glowing, scattering, or smooth glass with Fresnel whose faces pass all they do not reflect."""
    if any(material["transmission"]):
        if not material["fresnel"] or material["roughness"]["kind"] != "none" or any(material["absorption_per_m"]):
            raise ValueError(f"material {material['name']}: only smooth, clear Fresnel glass is known here")
        return {"bsdf": {"type": "dielectric", "int_ior": material["ior_by_band"][0], "ext_ior": 1.0}}
    found: dict[str, Any] = {
        "bsdf": {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(material["diffuse"])}}
    }
    if any(material["emission"]):
        found["emitter"] = {"type": "area", "radiance": rgb(material["emission"])}
    return found


def emitter(light: dict[str, Any]) -> dict[str, Any]:
    if light["kind"] == "directional":
        return {"type": "directional", "direction": light["direction"], "irradiance": rgb(light["irradiance"])}
    if light["kind"] == "point":
        return {"type": "point", "position": light["position"], "intensity": rgb(light["intensity"])}
    raise ValueError(f"light {light['kind']}: not known here")


def rgb(value: Any) -> dict[str, Any]:
    return {"type": "rgb", "value": list(value) if not isinstance(value, float) else [value] * 3}


def parts(scene: dict[str, Any]) -> list[dict[str, Any]]:
    """The scene under each light alone, and what glows alone; light adds up.

    A path tracer that picks one of several lights at random would be noisy where nothing is random, and in Vitrail
    what glows is seen and lights nothing.
    """
    dark = [each | {"emission": [0.0, 0.0, 0.0]} for each in scene["materials"]]
    black = [each | {"diffuse": [0.0, 0.0, 0.0]} for each in scene["materials"]]
    found = [scene | {"lights": [light], "materials": dark} for light in scene["lights"]]
    if any(any(each["emission"]) for each in scene["materials"]):
        found.append(scene | {"lights": [], "materials": black})
    return found


def render(scene: dict[str, Any], integrator: str, far_m: float, samples: int) -> list[np.ndarray]:
    """Two independent halves, (height, width, 3)."""
    method = mi.load_dict({"type": integrator, "max_depth": 64, "rr_depth": 1000})
    halves = []
    for seed in (1, 2):
        scenes = [mi.load_dict(translated(part, far_m, samples, seed)) for part in parts(scene)]
        halves.append(sum(np.array(mi.render(each, integrator=method, seed=seed)) for each in scenes))
    return halves


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("scene", type=Path)
    parser.add_argument("image", type=Path)
    parser.add_argument("--integrator", choices=("path", "ptracer"), default="path")
    parser.add_argument("--samples", type=int, default=64, help="of a pixel, in each half and for each light")
    parser.add_argument("--far-m", type=float, default=1e3, help="half the edge of a plane; ptracer aims at all of it")
    parser.add_argument("--variant", default="scalar_rgb")
    given = parser.parse_args()
    mi.set_variant(given.variant)
    mi.set_log_level(mi.LogLevel.Error)
    first, second = render(json.loads(given.scene.read_text()), given.integrator, given.far_m, given.samples)
    channels = ["R", "G", "B", *(f"{half}.{c}" for half in ("half_a", "half_b") for c in "RGB")]
    pixels = np.concatenate([(first + second) / 2, first, second], axis=2).astype(np.float32)
    mi.Bitmap(pixels, pixel_format=mi.Bitmap.PixelFormat.MultiChannel, channel_names=channels).write(str(given.image))


if __name__ == "__main__":
    main()
