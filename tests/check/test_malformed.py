"""Wrong scene files: each gets its messages, with place and remedy, and all of them at once.

The files in ``malformed/`` end in one comment line ``# expect LINE:COL: what; remedy`` for each message.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from vitrail.check.check import check_file

FOLDER = Path(__file__).parents[1] / "malformed"
FILES = sorted(FOLDER.glob("*.yaml"))


def messages(path: Path) -> list[str]:
    """The errors about a file, without its name."""
    return [str(error).removeprefix(f"{path}:") for error in check_file(path).errors]


def test_there_are_enough_of_them() -> None:
    assert len(FILES) >= 45


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_error_is_located_and_has_a_remedy(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    expected = [line.removeprefix("# expect ") for line in lines if line.startswith("# expect ")]
    assert expected
    assert messages(path) == expected
    assert not check_file(path).is_valid


def write(folder: Path, content: bytes) -> Path:
    path = folder / "scene.yaml"
    path.write_bytes(content)
    return path


NESTED = "a: " + "[" * 5000 + "]" * 5000
BOMB = "a: &a [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n" + "".join(
    f"{name}: &{name} [{', '.join([f'*{before}'] * 10)}]\n" for before, name in zip("abcdefgh", "bcdefghi", strict=True)
)
SELF = "a: &a [*a]"

UNREADABLE = {
    "empty": (b"", "1:1: the file is empty"),
    "comment only": (b"# nothing\n", "1:1: the file is empty"),
    "document mark only": (b"---\n", "1:1: the file is empty"),
    "list": (b"- 1\n", "1:1: a scene is a mapping of keys, this file is a list"),
    "text": (b"hello\n", "1:1: a scene is a mapping of keys, this file is text"),
    "number": (b"3\n", "1:1: a scene is a mapping of keys, this file is a single value"),
    "binary": (b"vitrail: 1\n\x7fELF\x00\x01", "2:1: control character 0x7f"),
    "nul": (b"vitrail: \x00", "1:10: control character 0x00"),
    "png": (b"\x89PNG\r\n\x1a\n", "1:1: byte 0x89 is not UTF-8 text"),
    "latin-1": ("vitrail: 1\ntitle: Übung".encode("latin-1"), "2:8: byte 0xdc is not UTF-8 text"),
    "deep": (NESTED.encode(), "1:36: nested deeper than 32 levels"),
    "bomb": (BOMB.encode(), "its aliases expand to more than 50000 values"),
    "alias of itself": (SELF.encode(), "1:8: alias `*a` stands for nothing finished before it"),
    "many values": (b"a: [" + b"1," * 60_000 + b"1]", "the file has more than 50000 values"),
    "too large": (b"#" * (4 * 1024 * 1024 + 1), "1:1: the file is larger than 4 MiB"),
    "long integer": (b"vitrail: " + b"9" * 5000, "1:10: 99999999999999999999... is too large for a number"),
    "integer beyond the range": (b"vitrail: " + b"9" * 350, "1:10: 99999999999999999999... is too large for a number"),
    "half a pair": (b'title: "\\ud83d"', "1:8: half of a character pair is no text"),
}


@pytest.mark.parametrize("case", UNREADABLE)
def test_what_is_no_scene_at_all(case: str, tmp_path: Path) -> None:
    content, expected = UNREADABLE[case]
    path = write(tmp_path, content)
    found = messages(path)
    assert any(expected in message for message in found), found
    assert all("; " in message for message in found)
    assert path.read_bytes() == content and list(tmp_path.iterdir()) == [path]


def test_a_missing_file_and_a_folder(tmp_path: Path) -> None:
    assert messages(tmp_path / "none.yaml") == ["1:1: there is no such file; check the path"]
    assert messages(tmp_path) == ["1:1: this is a folder; name a scene file inside it"]


def test_a_byte_order_mark_is_no_error(tmp_path: Path) -> None:
    text = Path("scenes/calibration/ball_lens.yaml").read_bytes()
    assert messages(write(tmp_path, b"\xef\xbb\xbf" + text)) == []
