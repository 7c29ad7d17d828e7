"""The photon map between shooting and gathering: the same photons, in a tree whose search misses none."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vitrail.engines.photon_file import (
    RECORD,
    PhotonFileError,
    fluxes_of,
    order_photon_file,
    ordered_tree,
    photons_of,
)


def random_photons(count: int, seed: int = 1) -> np.ndarray:
    rng = np.random.default_rng(seed)
    photons = np.zeros(count, RECORD)
    photons["position"] = rng.normal(size=(count, 3)) * (10, 1, 3)
    photons["colour"] = rng.integers(0, 255, (count, 4))
    photons["angles"] = rng.integers(-127, 127, (count, 2))
    return photons


def found_near(tree: np.ndarray, point: np.ndarray, radius: float) -> int:
    """POV-Ray's own search, ``PhotonGatherer::gatherPhotonsRec``, counting photons within ``radius``."""

    def search(start: int, end: int) -> int:
        middle = (end + start) >> 1
        photon = tree[middle]["position"].astype(float)
        axis = tree[middle]["axis"]
        count = int(((photon - point) ** 2).sum() < radius**2)
        if point[axis] - radius < photon[axis] and middle - 1 >= start:
            count += search(start, middle - 1)
        if point[axis] + radius > photon[axis] and end >= middle + 1:
            count += search(middle + 1, end)
        return count

    return search(0, len(tree) - 1)


@given(st.integers(1, 200), st.integers(0, 1000))
def test_the_search_finds_every_photon_of_a_ball(count: int, seed: int) -> None:
    photons = random_photons(count, seed)
    tree = ordered_tree(photons)
    for point in photons["position"][:5].astype(float) + 0.1:
        distance = np.sqrt(((photons["position"].astype(float) - point) ** 2).sum(axis=1))
        assert found_near(tree, point, 2.0) == int((distance < 2.0).sum())


def test_the_photons_stay_the_same() -> None:
    photons = random_photons(5000)
    tree = ordered_tree(photons)
    for name in ("position", "colour", "angles"):
        keys = [np.lexsort(each["position"].T) for each in (photons, tree)]
        assert np.array_equal(photons[name][keys[0]], tree[name][keys[1]])


def test_photons_at_one_place_and_on_one_line_end() -> None:
    same = np.zeros(1000, RECORD)
    assert len(ordered_tree(same)) == 1000
    line = random_photons(1000)
    line["position"][:, :2] = 0
    assert np.all(np.diff(ordered_tree(line)["position"][:, 2]) >= 0)


def test_a_file_keeps_what_follows_the_photons(tmp_path: Path) -> None:
    photons = random_photons(100)
    path = tmp_path / "photons.map"
    path.write_bytes(np.array([100], "<i4").tobytes() + photons.tobytes() + b"media map")
    order_photon_file(path)
    assert path.read_bytes().endswith(b"media map") and len(path.read_bytes()) == 4 + 2000 + 9


@pytest.mark.parametrize("raw", [b"", b"\x01", b"\x05\x00\x00\x00" + b"x" * 20, b"\xff\xff\xff\xff"])
def test_a_damaged_file_is_refused(raw: bytes) -> None:
    with pytest.raises(PhotonFileError):
        photons_of(raw)


def test_flux_is_the_byte_times_two_to_the_exponent() -> None:
    """[P 2.7] value = byte * 2^(e - 258)."""
    photon = np.zeros(1, RECORD)
    photon["colour"] = (128, 64, 255, 251)
    assert fluxes_of(photon)[0] == pytest.approx([1, 0.5, 255 / 128])
