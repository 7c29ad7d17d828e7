"""Bounds hold the whole shape, touch it, and scale with the scene to the last bit."""

from __future__ import annotations

import numpy as np
import pytest

from vitrail.geometry.lamp import bounds_of_light
from vitrail.geometry.placement import place
from vitrail.scene.model import Light, Object

TURNS = ([0, 0, 0], [90, 0, 0], [20, -35, 70])
SOLIDS = {
    "sphere": {"center": [0.2, 0.1, -0.3], "radius": 0.7},
    "box": {"min": [-0.5, -0.2, -0.9], "max": [0.6, 0.3, 0.1]},
    "cylinder": {"from": [0, -0.5, 0], "to": [0.3, 0.5, 0.2], "radius": 0.4},
    "cone": {"from": [0, 0, 0], "to": [0.5, 0.5, 0], "radius_from": 0.6, "radius_to": 0.1},
    "prism": {"apex_deg": 60, "side": 1, "height": 1.5},
    "lens": {"radius_front": 1.2, "radius_back": 2, "thickness": 0.5, "diameter": 1},
    "torus": {"center": [0.1, 0, 0.2], "normal": [1, 2, -1], "radius": 0.6, "radius_tube": 0.25},
    "lathe": {"profile": [[0, -0.6], [0.7, -0.6], [0.2, 0], [0.6, 0.5], [0.4, 0.5], [0, 0]]},
    "concave": {"radius_front": -1.2, "radius_back": -0.8, "thickness": 0.2, "diameter": 1},
}


def solid(kind: str, turn: list[float]) -> Object:
    key = "lens" if kind == "concave" else kind
    return Object.model_validate(
        {"name": "it", "material": "m", key: SOLIDS[kind], "rotate_deg": turn, "translate": [0.3, -0.2, 0.4]}
    )


@pytest.mark.parametrize("turn", TURNS)
@pytest.mark.parametrize("kind", SOLIDS)
def test_bounds_hold_every_inner_point_and_are_no_larger_than_the_turned_box(kind: str, turn: list[float]) -> None:
    item = place(solid(kind, turn))
    bounds = item.bounds
    points = np.random.default_rng(1).uniform(-1.2, 1.6, (100_000, 3))
    inside = points[item.depth(points) > 0]
    assert len(inside) > 500
    assert (inside >= np.array(bounds.low)).all()
    assert (inside <= np.array(bounds.high)).all()
    # Unturned bounds are tight; 500 points leave a gap of a few per cent of the size.
    if turn == [0, 0, 0]:
        gap = np.maximum(inside.min(axis=0) - bounds.low, bounds.high - inside.max(axis=0))
        assert (gap < 0.15 * np.subtract(bounds.high, bounds.low)).all()


@pytest.mark.parametrize("kind", ["disc", "rectangle"])
def test_flat_bounds_hold_their_edge(kind: str) -> None:
    shapes = {
        "disc": {"center": [0.1, 0.2, 0.3], "normal": [1, 2, 3], "radius": 0.5},
        "rectangle": {"center": [0.1, 0.2, 0.3], "u": [0.4, 0.1, 0], "v": [0, 0, 0.3]},
    }
    bounds = place(Object.model_validate({"name": "it", "material": "m", kind: shapes[kind]})).bounds
    angle = np.linspace(0, 2 * np.pi, 1000)
    if kind == "disc":
        n = np.array([1, 2, 3]) / np.sqrt(14)
        u = np.cross(n, [1, 0, 0]) / np.linalg.norm(np.cross(n, [1, 0, 0]))
        edge = 0.5 * (np.outer(np.cos(angle), u) + np.outer(np.sin(angle), np.cross(n, u)))
    else:
        edge = np.array([[a * 0.4, a * 0.1, b * 0.3] for a in (-1, 1) for b in (-1, 1)])
    edge = edge + [0.1, 0.2, 0.3]
    # The rim is sampled every 0.36 degrees: cos(0.18 deg) leaves 5e-6 of the radius.
    assert np.allclose(edge.min(axis=0), bounds.low, atol=1e-5)
    assert np.allclose(edge.max(axis=0), bounds.high, atol=1e-5)


def test_infinite_things_have_infinite_bounds() -> None:
    floor = {"name": "it", "material": "m", "plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}}
    assert not place(Object.model_validate(floor)).bounds.is_finite
    sun = {"name": "sun", "directional": {"direction": [0, -1, 0], "irradiance": 1}}
    assert not bounds_of_light(Light.model_validate(sun)).is_finite
