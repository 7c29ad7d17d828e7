"""Small scenes for the plan's tests: a floor under a sun, and what a test puts between them."""

from __future__ import annotations

from vitrail.scene.load import load_text
from vitrail.scene.model import Scene

FLOOR = "{name: floor, plane: {point: [0, 0, 0], normal: [0, 1, 0]}, material: white}"
SUN = "{name: sun, directional: {direction: [0, -1, 0], irradiance: 3}}"
BALL = "{name: ball, sphere: {center: [0, 2, 0], radius: 1}, material: %s}"
DOWN = "{position: [0, 8, 0], look_at: [0, 0, 0], up: [0, 0, -1], fov_deg: 40}"
MATERIALS = """
  white: {diffuse: 0.8}
  black: {}
  clear: {transmission: 1, ior: 1.5}
  window: {transmission: 1, ior: 1.5, fresnel: true}
  mirror: {reflection: 0.9}
  faint_mirror: {reflection: 1e-7}
  red: {transmission: [0.9, 0.3, 0.1], ior: 1.5}
  flint: {transmission: 1, ior: 1.6, dispersion: 0.032}
  barely_flint: {transmission: 1, ior: 1.6, dispersion: 1e-14}
  faint_flint: {transmission: 1, ior: 1.6, dispersion: 1e-12}
  bk7: {transmission: 1, glass: N-BK7}
  frosted: {transmission: 1, ior: 1.5, roughness: 0.3}
  milky: {diffuse: 0.5, transmission: 0.5, ior: 1.5}
  barely_frosted: {transmission: 1, ior: 1.5, roughness: 1e-7}
  ggx: {transmission: 1, ior: 1.5, roughness: {ggx: 0.1}}
  smoky: {transmission: 1, ior: 1.5, absorption_per_m: [0.1, 0.2, 0.3]}
  barely_smoky: {transmission: 1, ior: 1.5, absorption_per_m: 1e-9}
  air: {transmission: 1, ior: 1}
  bubble: {transmission: 1, ior: 0.8}
"""


def make(
    *objects: str,
    lights: tuple[str, ...] = (SUN,),
    camera: str = DOWN,
    transport: str = "{}",
    paper: str = "{}",
    observe: tuple[str, ...] = (),
) -> Scene:
    """A scene of these objects, each in flow style; 100 x 100 pixels."""
    lines = ["vitrail: 1", f"camera: {camera}", "image: {width: 100, height: 100}", "materials:" + MATERIALS.rstrip()]
    for key, items in (("objects", objects), ("lights", lights), ("observe", observe)):
        lines.append(f"{key}:" + ("" if items else " []"))
        lines += [f"  - {item}" for item in items]
    lines += [f"transport: {transport}", f"paper: {paper}"]
    return load_text("\n".join(lines)).scene


def ball_over_floor(material: str = "clear", **parts: object) -> Scene:
    """A ball of radius 1, two above a white floor, under a vertical sun, seen from above."""
    return make(FLOOR, BALL % material, **parts)  # type: ignore[arg-type]
