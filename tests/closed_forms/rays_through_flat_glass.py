"""Slabs, stacks, wedges, rods: single rays against closed forms. Each function returns its largest error."""

from __future__ import annotations

import math

from mpmath import asin, atan, cos, degrees, exp, mpf, radians, sin

from tests.closed_forms import slabs
from tests.closed_forms.one_ray import angle_between, before, down_at, events, follow, sideways

SAME_DIRECTION = 1e-9
"""Radians between the ways before and behind a slab."""


def block(low, high, keys):
    """A box as wide as a street between two heights."""
    return f"""
materials: {{glass: {{transmission: 1, {keys}}}}}
objects: [{{name: block, box: {{min: [-50, {low}, -50], max: [50, {high}, 50]}}, material: glass}}]
"""


def slab_shift():
    """A slab moves a ray sideways by d sin(i - r) / cos r; index 0.8 moves it the other way."""
    worst = 0
    for index in ("1.5", "0.8", "1.000001"):
        for incidence in (0, 10, 30, 50):
            vertices = follow(
                block(-1, 0, f"ior: {index}"), before((0, 0, 0), down_at(incidence), 3), down_at(incidence)
            )
            assert angle_between(vertices[0]["direction_in"], vertices[-1]["direction_out"]) < SAME_DIRECTION
            worst = max(worst, abs(sideways(vertices) - abs(slabs.sideways(mpf(index), incidence, 1))))
    return worst


def critical_angle():
    """Halve the interval until the tracer itself says where light can no longer leave glass of 1.5."""
    below, above = 41.0, 43.0
    for _ in range(34):
        middle = (below + above) / 2
        way = (math.sin(math.radians(middle)), math.cos(math.radians(middle)), 0.0)
        leaves = follow(block(-9, 0, "ior: 1.5"), (0.0, -0.5, 0.0), way)[0]["event"] == "exit"
        below, above = (middle, above) if leaves else (below, middle)
    return abs(radians(mpf(below)) - asin(1 / mpf("1.5")))


def brewster():
    """At atan n the mirrored ray is at right angles to the bent one, and only s light is mirrored: R = Rs / 2."""
    worst = 0
    for index in ("1.5", "1.7"):
        n = mpf(index)
        angle = float(degrees(atan(n)))
        body, start = block(-1, 0, f"ior: {index}, fresnel: true"), before((0, 0, 0), down_at(angle), 3)
        bent, mirrored = (follow(body, start, down_at(angle), branch=b)[0] for b in ("transmit", "reflect"))
        square = abs(angle_between(bent["direction_out"], mirrored["direction_out"]) - radians(90))
        half_of_s = ((n * n - 1) / (n * n + 1)) ** 2 / 2
        worst = max(worst, square, abs(bent["R"] - half_of_s), abs(mirrored["throughput"][0] - half_of_s))
    return worst


def face_shares():
    """Fresnel's R at one face, from air and from glass."""
    worst = 0
    for incidence in (0, 30, 60, 80, 89.9):
        truth = slabs.fresnel(mpf("1.5"), incidence)
        way = down_at(incidence)
        vertices = follow(block(-1, 0, "ior: 1.5, fresnel: true"), before((0, 0, 0), way, 0.05), way)
        for vertex in vertices[:2]:
            worst = max(worst, abs(vertex["R"] - truth), abs(vertex["T"] - (1 - truth)))
    return worst


def slab_transmittance():
    """Straight through a slab go T^2; with the mirrors at its two faces all bounces come to T^2 / (1 - R^2)."""
    worst = 0
    for incidence in (0, 30, 60, 80):
        way = down_at(incidence)
        vertices = follow(block(-1, 0, "ior: 1.5, fresnel: true"), before((0, 0, 0), way, 0.1), way)
        straight, inside = vertices[1]["throughput"][0], vertices[1]["R"]
        worst = max(worst, abs(straight / (1 - inside**2) - slabs.slab(mpf("1.5"), incidence)))
    return worst


def stack_transmittance():
    """Straight through five slabs go T^10."""
    slab = "{{name: s{k}, box: {{min: [-50, {low}, -50], max: [50, {high}, 50]}}, material: glass}}"
    objects = ", ".join(slab.format(k=k, low=-2 * k - 1, high=-2 * k) for k in range(5))
    body = f"materials: {{glass: {{transmission: 1, ior: 1.5, fresnel: true}}}}\nobjects: [{objects}]\n"
    vertices = follow(body, before((0, 0, 0), down_at(30), 1), down_at(30))
    assert events(vertices) == "enter exit " * 5 + "escape"
    return abs(vertices[-1]["throughput"][0] - (1 - slabs.fresnel(mpf("1.5"), 30)) ** 10)


def beer_wedge():
    """A wedge of slope 1/2 leaves exp(-a x / 2), and a slab of index 1.5 exp(-a d / cos r)."""
    wedge = """
materials: {matter: {transmission: 1, ior: 1, absorption_per_m: [1, 2, 4]}}
objects: [{name: wedge, prism: {profile: [[0, 0], [1, 0], [1, 0.5]], height: 1}, material: matter}]
"""
    worst = 0
    for x in (0.1, 0.5, 0.9):
        left = follow(wedge, (x, 2.0, 0.1), (0.0, -1.0, 0.0))[-1]["throughput"]
        worst = max(worst, *(abs(left[c] - exp(-mpf(a) * mpf(x) / 2)) for c, a in enumerate((1, 2, 4))))
    for incidence in (0, 60):
        way = down_at(incidence)
        left = follow(block(-1, 0, "ior: 1.5, absorption_per_m: [1, 2, 4]"), before((0, 0, 0), way, 0.1), way)
        inside = cos(asin(sin(radians(mpf(incidence))) / mpf("1.5")))
        worst = max(worst, *(abs(left[-1]["throughput"][c] - exp(-a / inside)) for c, a in enumerate((1, 2, 4))))
    return worst


def light_pipe():
    """In a square rod a ray is mirrored to and fro; unfolded it is straight. Nothing is lost on the way."""
    body = """
materials: {glass: {transmission: 1, ior: 1.5}}
objects: [{name: rod, box: {min: [-0.5, -40, -0.5], max: [0.5, 0, 0.5]}, material: glass}]
"""
    worst = 0
    for incidence in (5, 30, 60, 85):
        way = down_at(incidence)
        vertices = follow(body, before((0.1, 0, 0), way, 0.05), way)
        inside = asin(sin(radians(mpf(incidence))) / mpf("1.5"))
        unfolded = mpf("0.1") + 40 * sin(inside) / cos(inside) + mpf("0.5")
        bounces = int(unfolded)
        place = (unfolded - bounces if bounces % 2 == 0 else 1 - (unfolded - bounces)) - mpf("0.5")
        assert events(vertices) == "enter " + "total_internal_reflection " * bounces + "exit escape"
        assert vertices[-1]["throughput"] == [1.0, 1.0, 1.0]
        out = vertices[-1]["direction_out"]
        worst = max(worst, abs(vertices[-2]["point"][0] - place), abs(-out[1] - cos(radians(mpf(incidence)))))
    return worst


def two_glasses():
    """From glass into water at 40 degrees: 46.3 and not the 74.6 degrees of glass into air [O 1.1 item 5]."""
    body = """
materials: {glass: {transmission: 1, ior: 1.5}, water: {transmission: 1, ior: 1.3333333333333333}}
objects:
  - {name: above, box: {min: [-9, 0, -9], max: [9, 1, 9]}, material: glass}
  - {name: below, box: {min: [-9, -1, -9], max: [9, 0, 9]}, material: water}
"""
    way = down_at(40)
    bent = follow(body, before((0, 0, 0), way, 0.5), way)[0]
    found = angle_between(bent["direction_out"], (0.0, -1.0, 0.0))
    truth = asin(mpf("1.5") * sin(radians(mpf(40))) / (mpf(4) / 3))
    assert abs(degrees(truth) - mpf("46.3")) < mpf("0.05")
    return abs(found - truth)
