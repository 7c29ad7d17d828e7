"""The error that a plan may make: whatever is smaller is left out, with a warning that carries its size."""

from __future__ import annotations

SHARE = 1e-6
"""Of the light concerned: a mirror that returns less, or glass that absorbs less on its way, is left out.

A thousandth of the noise of the best rendering the project makes, and a tenth of what its tightest closed form tests.
"""

PIXELS = 0.01
"""Of shift on the screen: colours that part by less, and faces that blur by less, are left out.

At a hard edge of full contrast such a shift changes one pixel by 1 %, and no pixel average.
"""
