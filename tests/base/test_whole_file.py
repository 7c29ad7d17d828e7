"""A file is there whole, or as it was before."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from vitrail.base.whole_file import whole_file, write_whole


def test_text_and_bytes_arrive_and_everybody_may_read_them(tmp_path: Path) -> None:
    write_whole(tmp_path / "deep" / "text", "é\n")
    write_whole(tmp_path / "deep" / "bytes", b"\x00\xff")
    assert (tmp_path / "deep" / "text").read_bytes() == b"\xc3\xa9\n"
    assert (tmp_path / "deep" / "bytes").read_bytes() == b"\x00\xff"
    assert (tmp_path / "deep" / "text").stat().st_mode & 0o777 == 0o644


def test_a_write_that_fails_leaves_the_old_file_and_nothing_beside_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_whole(tmp_path / "file", "old")

    def full(*arguments: object) -> None:
        raise OSError("no space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(OSError, match="no space"):
        write_whole(tmp_path / "file", "new")
    assert (tmp_path / "file").read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_writer_that_fails_half_way_leaves_the_old_file(tmp_path: Path) -> None:
    write_whole(tmp_path / "image.exr", "old")
    with pytest.raises(ZeroDivisionError), whole_file(tmp_path / "image.exr", durable=True) as partial:
        # Image libraries choose the format by the suffix.
        assert partial.suffix == ".exr"
        partial.write_text("half of the n")
        raise ZeroDivisionError
    assert (tmp_path / "image.exr").read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["image.exr"]


def test_an_error_names_the_file_that_was_wanted(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError) as error, whole_file(tmp_path / "image.exr") as partial:
        partial.read_bytes()
    assert error.value.filename == str(tmp_path / "image.exr")
