"""Back end for POV-Ray 3.7: scene text, runs, and a certificate of what POV-Ray does differently.

A scene goes through five rooms. ``refusals`` turns away what POV-Ray cannot do, with the line that asks for it.
``bodies`` brings what is left to units that POV-Ray resolves, opens gaps, joins contacts and cuts what is nested.
``photons`` chooses how deep to trace, where to aim photons, how densely, and at which brightness they are stored
exactly. All this is one value, the ``Translation``. From it ``text`` builds a tree of POV-Ray's language for every run
and prints it once, and ``certificate`` states every law that POV-Ray follows differently, with its size. ``lower.py``
walks through them: begin there. ``readable`` writes the same translation once more, as one file for a person.

[P n] refers to the measurements of POV-Ray 3.7.0.10 listed in ``docs/sources.md``.
"""

from vitrail.lower.povray.lower import PovrayPicture, PovrayRun, PovrayScene, lower_povray
from vitrail.lower.povray.readable.readable import ReadableScene, lower_readable
from vitrail.lower.povray.refusals.refusal import NotTranslatable
from vitrail.lower.povray.text.edit import NothingToEdit

__all__ = [
    "NotTranslatable",
    "NothingToEdit",
    "PovrayPicture",
    "PovrayRun",
    "PovrayScene",
    "ReadableScene",
    "lower_povray",
    "lower_readable",
]
