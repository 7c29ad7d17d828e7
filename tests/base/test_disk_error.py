"""What the disk refuses is said in one line with its place."""

from __future__ import annotations

import shutil

from vitrail.base.disk_error import is_disk_error, words_of


def test_a_folder_that_cannot_be_copied_names_its_first_file() -> None:
    """As ``shutil.copytree`` says it on a full disk: a list of sources, targets and words."""
    error = shutil.Error([("a", "out/a", "[Errno 28] No space left on device: 'a' -> 'out/a'"), ("b", "out/b", "x")])
    assert is_disk_error(error) and words_of(error) == "out/a: no space left on device"


def test_an_error_without_a_file_that_is_not_of_the_disk_is_a_defect() -> None:
    assert not is_disk_error(OSError(9, "Bad file descriptor"))
    assert is_disk_error(OSError(27, "File too large")) and words_of(OSError(27, "X")) == "the disk: x"
