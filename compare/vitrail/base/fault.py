"""What is wrong, what to do about it, and where: one error that is never parsed back from its sentence."""

from __future__ import annotations

Path = tuple[str | int, ...]


class Fault(ValueError):
    """A value that cannot be used. ``what`` is wrong with it, ``remedy`` is what its author can do.

    ``path`` leads to the value from the top of what was read, keys and indices; it is empty where whoever catches the
    fault knows the place, as a scene's reader does. Printed it reads ``what; remedy``, after the path if there is one.
    """

    def __init__(self, what: str, remedy: str, path: Path = ()) -> None:
        self.what, self.remedy, self.path = what, remedy, path
        super().__init__(what, remedy, path)

    def __str__(self) -> str:
        place = f"`{'.'.join(map(str, self.path))}` " if self.path else ""
        return f"{place}{self.what}; {self.remedy}"
