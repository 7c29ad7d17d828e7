"""Each gate has its own question and its own message."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from vitrail.judge.gates import Inspected, check_gates, gate_same_exposure

HASH = "a" * 64


def good(side: str = "tracer", **changes: object) -> Inspected:
    image = Inspected(
        side=side,
        file=f"{side}.exr",
        width=4,
        height=3,
        channels=("R", "G", "B"),
        pixel_type="float",
        radiance=np.ones((3, 4, 3)),
        metadata={"vitrail:scene_hash": HASH, "vitrail:settings": '{"gather_radius_m": 0.01, "seed": 1}'},
    )
    return replace(image, **changes)


def failures(*images: Inspected) -> list[tuple[str, str]]:
    return [(gate.gate, gate.message) for gate in check_gates(4, 3, HASH, images) if not gate.passed]


def test_good_images_pass() -> None:
    assert failures(good(), good("povray")) == []
    assert len(check_gates(4, 3, HASH, [good(), good("povray")])) == 17


def test_the_first_bad_pixel_is_named() -> None:
    radiance = np.ones((3, 4, 3))
    radiance[1, 2, 1] = np.nan
    radiance[2, 0, 0] = np.inf
    (gate, message), *rest = failures(good(radiance=radiance))
    assert gate == "finite" and not rest
    assert "tracer.exr has nan at pixel x=2 y=1 (channel G), 2 bad in all" in message


@pytest.mark.parametrize(
    ("gate", "changes", "says"),
    [
        ("size", {"width": 5}, "is 5 x 3, the scene says 4 x 3"),
        ("channels", {"channels": ("Y",)}, "has no channel R, G, B; found Y"),
        ("linear", {"pixel_type": "uint8"}, "holds uint8 pixels"),
        ("light", {"radiance": np.zeros((3, 4, 3))}, "is black everywhere"),
        ("exposure", {"metadata": {"vitrail:exposure_stops": "1.5"}}, "exposed by 1.5 stops"),
        (
            "scene",
            {"metadata": {"vitrail:scene_hash": "b" * 64}},
            "shows scene bbbbbbbbbbbb, this scene is aaaa",
        ),
    ],
)
def test_each_gate_has_its_own_message(gate: str, changes: dict[str, object], says: str) -> None:
    found = failures(good(**changes))
    assert [name for name, _ in found] == [gate]
    assert says in found[0][1]


def test_kernels_of_two_widths_are_not_compared() -> None:
    wide = good("povray", metadata={"vitrail:settings": '{"gather_radius_m": 0.02, "seed": 2}'})
    assert failures(good(), wide) == [("settings", "tracer and povray: gather_radius_m 0.01 against 0.02")]


def test_a_foreign_image_need_not_say_its_scene() -> None:
    assert failures(good(metadata={})) == []


def test_a_picture_that_is_exposed_without_saying_so_is_no_finding() -> None:
    ramp = np.linspace(0.1, 1, 36).reshape(3, 4, 3)
    dim, bright = good("candidate", radiance=ramp), good("reference", radiance=2 * ramp)
    gate = gate_same_exposure(dim, bright)
    assert not gate.passed and "is 0.5 times reference.exr at every pixel (-1.00 stops)" in gate.message
    # A few per cent may be a finding, and so is whatever is not the same everywhere.
    assert gate_same_exposure(dim, good("reference", radiance=1.05 * ramp)).passed
    assert gate_same_exposure(dim, good("reference", radiance=2 * ramp + 0.01)).passed


def test_halves_that_are_of_another_picture_are_refused_where_they_differ() -> None:
    ones = np.ones((3, 4, 3))
    noisy = ones + np.random.default_rng(1).uniform(-0.9, 0.9, ones.shape)
    assert failures(good(halves=(noisy, 2 * ones - noisy))) == []
    rounded = np.float16(noisy).astype(float), np.float16(2 * ones - noisy).astype(float)
    assert failures(good(halves=rounded, pixel_type="half")) == []
    ((gate, message),) = failures(good(halves=(1.2 * ones, 1.1 * ones)))
    assert (
        gate == "halves" and "tracer.exr is 1 at pixel x=0 y=0 (channel R) and the mean of its halves 1.15" in message
    )


def test_integers_are_refused_for_what_they_are_and_not_for_being_black() -> None:
    ((gate, message),) = failures(good(radiance=np.zeros((3, 4, 3)), pixel_type="uint32"))
    assert gate == "linear" and "holds uint32 pixels; write linear float or half (EXR)" in message
