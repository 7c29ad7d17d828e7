"""Errors of the disk, which are the user's to mend, apart from other errors of the system, which are nobody's."""

from __future__ import annotations

import errno
import os
import shutil

FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


def is_disk_error(error: OSError) -> bool:
    """Whether an error names a file, or says that the disk is full; writing to a full disk names no file."""
    return isinstance(error, shutil.Error) or error.filename is not None or error.errno in FULL


def words_of(error: OSError) -> str:
    """The place and what is wrong there. A folder that could not be copied has an error for each of its files."""
    if isinstance(error, shutil.Error):
        _, place, why = error.args[0][0]
        return f"{place}: {_full_or(str(why))}"
    return f"{error.filename or 'the disk'}: {(error.strerror or 'it cannot be used').lower()}"


def is_full(words: str) -> bool:
    """Whether a program that ended says that it could not write for want of room."""
    return any(os.strerror(number) in words for number in FULL)


def _full_or(why: str) -> str:
    return next((os.strerror(number).lower() for number in FULL if os.strerror(number) in why), why)
