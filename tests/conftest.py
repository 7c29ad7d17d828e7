"""Property tests are about values and never about time: a busy machine must not fail them."""

from __future__ import annotations

from hypothesis import settings

settings.register_profile("vitrail", deadline=None)
settings.load_profile("vitrail")
