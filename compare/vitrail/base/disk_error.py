"""Errors of the disk, which are the user's to mend, apart from other errors of the system, which are nobody's."""

from __future__ import annotations

import errno


def is_disk_error(error: OSError) -> bool:
    """Whether an error names a file, or says that the disk is full; writing to a full disk names no file."""
    return error.filename is not None or error.errno in (errno.ENOSPC, errno.EDQUOT)
