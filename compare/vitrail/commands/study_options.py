"""What the studies share on the command line: the bar that shows how far they are, and how they end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from vitrail.commands.progress_bar import progress_bar

if TYPE_CHECKING:
    from vitrail.pipeline.queue import Progress


@contextmanager
def study_progress(title: str) -> Iterator[Callable[[Progress], None]]:
    """A bar over the tasks of a study; rich shows the time left."""
    with progress_bar(title) as show:

        def report(progress: Progress) -> None:
            show("tasks", float(progress.done), float(progress.total))

        yield report
