"""Back end for POV-Ray 3.7: scene text, runs, and a certificate of what POV-Ray does differently.

[P n] refers to the measurements of POV-Ray 3.7.0.10 listed in ``docs/sources.md``.
"""

from vitrail.lower.povray.lower import PovrayRun, PovrayScene, lower_povray
from vitrail.lower.povray.refusals.refusal import NotTranslatable
from vitrail.lower.povray.text.edit import NothingToEdit

__all__ = ["NotTranslatable", "NothingToEdit", "PovrayRun", "PovrayScene", "lower_povray"]
