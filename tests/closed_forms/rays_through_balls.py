"""Drops, balls, shells, bubbles: single rays against closed forms. Each function returns its largest error."""

from __future__ import annotations

import math

from mpmath import asin, mpf, radians, sin, sqrt

from tests.closed_forms import ball_lens, hollow, prisms
from tests.closed_forms.one_ray import angle_between, axis_crossing, before, down_at, events, follow, turn

DROP = """
materials: {{water: {{reflection: 0.1, transmission: 0.9, ior: {index}}}}}
objects: [{{name: drop, sphere: {{center: [0, 0, 0], radius: 1}}, material: water}}]
"""


def bow_turn(b, bounces):
    """The turn of a ray by a drop of water, piece by piece: in, ``bounces`` mirrorings, out; radians, all of them."""
    body = DROP.format(index="1.333")
    first = follow(body, (float(b), 2.0, 0.0), (0.0, -1.0, 0.0))[0]
    point, way = first["point"], first["direction_out"]
    turned = angle_between(first["direction_in"], way)
    for bounce in range(bounces + 1):
        # Start the next piece in the middle of the chord: a tracer follows one kind of branch at a time.
        half = -sum(p * d for p, d in zip(point, way, strict=True))
        start = tuple(p + half * d for p, d in zip(point, way, strict=True))
        vertex = follow(body, start, tuple(way), branch="reflect" if bounce < bounces else "transmit")[0]
        turned += angle_between(way, vertex["direction_out"])
        point, way = vertex["point"], vertex["direction_out"]
    return turned


def rainbows():
    """Where the turn stands still, at cos i = sqrt((n^2 - 1) / (k (k + 2))), it is that of the bow."""
    worst = 0
    for bounces in (1, 2):
        n = mpf("1.333")
        b = sin(mp_acos(sqrt((n * n - 1) / (bounces * (bounces + 2)))))
        turned = math.degrees(bow_turn(b, bounces))
        worst = max(worst, radians(abs(abs(180 - turned % 360) - prisms.rainbow_deg(n, bounces))))
        # It stands still there: rays beside it are turned more, by the square of the distance.
        for beside in (-1e-3, 1e-3):
            assert 1e-8 < math.radians(math.degrees(bow_turn(b + mpf(beside), bounces)) - turned) < 1e-4
    return worst


def mp_acos(x):
    return radians(90) - asin(x)


def ball():
    """A ball over a plane: where its rays land [O 1.6]."""
    body = """
materials: {clear: {transmission: 1, ior: 1.5}, floor: {diffuse: 0.5}}
objects:
  - {name: ball, sphere: {center: [0, 0, 0], radius: 1}, material: clear}
  - {name: floor, plane: {point: [0, -2, 0], normal: [0, 1, 0]}, material: floor}
"""
    worst = 0
    for b in (0.01, 0.3, 0.6, 0.9):
        vertices = follow(body, (b, 2.0, 0.0), (0.0, -1.0, 0.0))
        worst = max(worst, abs(vertices[-1]["point"][0] - ball_lens.landing(mpf(b), mpf("1.5"), mpf(2))))
    return worst


HOLLOW = """
materials: {glass: {transmission: 1, ior: 1.5}, air: {transmission: 1, ior: 1}}
objects:
  - {name: shell, sphere: {center: [0, 0, 0], radius: 1}, material: glass}
  - {name: hollow, sphere: {center: [0, 0, 0], radius: 0.9}, material: air, priority: 1}
"""


def shell():
    """A shell turns rays away from its axis; where they seem to come from tends to its focus."""
    worst = 0
    for b in (0.01, 0.3, 0.6, 0.85):
        vertices = follow(HOLLOW, (b, 2.0, 0.0), (0.0, -1.0, 0.0))
        assert events(vertices) == "enter enter exit exit escape"
        worst = max(worst, abs(-turn(vertices) - hollow.shell_turn(b, mpf("1.5"), mpf("0.9"))))
        _, crossing = axis_crossing(vertices)
        truth = hollow.shell_crossing(b, mpf("1.5"), mpf("0.9"))
        worst = max(worst, abs(-crossing / truth - 1))
    # Near the axis the crossing is the focus, to the square of the height.
    near = -hollow.shell_crossing(mpf("1e-6"), mpf("1.5"), mpf("0.9")) / -hollow.shell_focus(mpf("1.5"), mpf("0.9"))
    assert abs(near - 1) < mpf("1e-11")
    return worst


def bubble():
    """A bubble of air in glass turns rays away, and mirrors those that pass its centre farther off than r / n."""
    body = """
materials: {glass: {transmission: 1, ior: 1.5}, air: {transmission: 1, ior: 1}}
objects:
  - {name: block, box: {min: [-9, -9, -9], max: [9, 9, 9]}, material: glass}
  - {name: bubble, sphere: {center: [0, 0, 0], radius: 0.5}, material: air, priority: 1}
"""
    worst = 0
    for b in (0.01, 0.2, 0.33, 0.34, 0.45):
        vertices = follow(body, (b, 2.0, 0.0), (0.0, -1.0, 0.0))
        if 1.5 * b < 0.5:
            assert events(vertices).startswith("enter exit")
            truth = hollow.bubble_turn(b, mpf("1.5"), mpf("0.5"))
            found = -turn(vertices[:2])
        else:
            assert vertices[0]["event"] == "total_internal_reflection"
            truth = hollow.bubble_mirror_turn(b, mpf("0.5"))
            found = angle_between(vertices[0]["direction_in"], vertices[0]["direction_out"])
        worst = max(worst, abs(found - truth))
    return worst


def invisible_glass():
    """Glass of index 1: the ray keeps every bit of its direction, and all of its light."""
    body = DROP.replace("reflection: 0.1, transmission: 0.9, ior: {index}", "transmission: 1, ior: 1, fresnel: true")
    body = body.format()
    worst = 0.0
    for b in (0.1, 0.9, 0.999999):
        way = down_at(20)
        vertices = follow(body, before((b, 0, 0), way, 3), way)
        assert vertices[-1]["direction_out"] == vertices[0]["direction_in"]
        worst = max(worst, *(abs(share - 1) for share in vertices[-1]["throughput"]))
    return worst
