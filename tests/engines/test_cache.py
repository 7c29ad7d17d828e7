"""Renderings are kept by content: found again, made once, never half."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from vitrail.engines.base import Rendering
from vitrail.engines.cache import Cache, content_key


def painter(calls: list[str], *, interrupted: bool = False):
    def render(folder: Path) -> Rendering:
        calls.append(folder.name)
        (folder / "tracer.exr").write_text(f"image {len(calls)}")
        return Rendering(folder / "tracer.exr", {"interrupted": interrupted, "number": len(calls)})

    return render


def test_the_second_time_nothing_is_rendered(tmp_path: Path) -> None:
    cache, calls = Cache(tmp_path), []
    first = cache.rendered("a" * 64, painter(calls))
    second = Cache(tmp_path).rendered("a" * 64, painter(calls))
    assert first == second
    assert len(calls) == 1
    assert second.image_path.read_text() == "image 1"
    assert second.record["number"] == 1


def test_an_interrupted_rendering_is_not_kept(tmp_path: Path) -> None:
    cache, calls = Cache(tmp_path), []
    half = cache.rendered("a" * 64, painter(calls, interrupted=True))
    assert half.image_path.read_text() == "image 1"
    assert cache.find("a" * 64) is None
    assert not cache.rendered("a" * 64, painter(calls)).interrupted


def test_a_failed_rendering_leaves_nothing(tmp_path: Path) -> None:
    def fail(folder: Path) -> Rendering:
        (folder / "half").write_text("half")
        raise RuntimeError("the engine fell")

    with pytest.raises(RuntimeError):
        Cache(tmp_path).rendered("a" * 64, fail)
    assert list(tmp_path.rglob("*")) == []


def test_a_damaged_entry_is_made_again(tmp_path: Path) -> None:
    cache, calls = Cache(tmp_path), []
    kept = cache.rendered("a" * 64, painter(calls))
    kept.image_path.unlink()
    assert cache.rendered("a" * 64, painter(calls)).image_path.read_text() == "image 2"


def test_many_at_once_agree_on_one_entry(tmp_path: Path) -> None:
    cache, calls = Cache(tmp_path), []
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda _: cache.rendered("a" * 64, painter(calls)), range(16)))
    assert len({item.image_path for item in found}) == 1
    assert not list(tmp_path.glob(".work-*"))


def test_the_key_depends_on_every_part() -> None:
    keys = [
        content_key("tracer", "1", ["scene"]),
        content_key("povray", "1", ["scene"]),
        content_key("tracer", "2", ["scene"]),
        content_key("tracer", "1", ["scene", ""]),
        content_key("tracer", "1", ["sce", "ne"]),
    ]
    assert len(set(keys)) == len(keys)
    assert content_key("tracer", "1", ["scene"]) == keys[0]
