"""Compressed data reads back the same, is the same bytes whenever it is the same text, and is small."""

from __future__ import annotations

import gzip
from pathlib import Path

from vitrail.base.packed import kind_of, read_packed, write_packed

TEXT = '{"key": "é", "value": 0.1}\n' * 1000


def test_the_name_says_whether_a_file_is_compressed(tmp_path: Path) -> None:
    for name in ("rows.jsonl", "rows.jsonl.gz"):
        write_packed(tmp_path / name, TEXT)
        assert read_packed(tmp_path / name) == TEXT
    assert (tmp_path / "rows.jsonl").read_text() == TEXT
    assert gzip.decompress((tmp_path / "rows.jsonl.gz").read_bytes()).decode() == TEXT
    assert len((tmp_path / "rows.jsonl.gz").read_bytes()) < len(TEXT) / 50


def test_the_same_text_gives_the_same_bytes_at_any_time_and_under_any_name(tmp_path: Path) -> None:
    write_packed(tmp_path / "first.gz", TEXT)
    write_packed(tmp_path / "second.gz", TEXT)
    content = (tmp_path / "first.gz").read_bytes()
    assert content == (tmp_path / "second.gz").read_bytes()
    # RFC 1952: bytes 4 to 7 are the time, and bit 3 of byte 3 says that a name follows.
    assert content[4:8] == bytes(4) and not content[3] & 8


def test_the_kind_of_a_file_is_its_name_without_its_endings() -> None:
    assert kind_of(Path("docs/agreement.json.gz")) == kind_of(Path("agreement.json")) == "agreement"
