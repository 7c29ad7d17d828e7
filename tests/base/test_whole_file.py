"""A file is there whole, or as it was before."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from vitrail.base.whole_file import write_whole


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
