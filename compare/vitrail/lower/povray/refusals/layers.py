"""Layered textures where POV-Ray takes none: in a look that is one inside a body and another outside it.

Coloured glass that scatters is two layers in a run that shows all channels. Nested in other glass its inner face looks
different where that glass lies behind it, and POV-Ray's pattern of an object holds single textures: it does not parse
layers.
"""

from __future__ import annotations

from vitrail.lower.povray.asked import Asked
from vitrail.lower.povray.bodies.nesting import Nesting
from vitrail.lower.povray.refusals.refusal import NotTranslatable
from vitrail.lower.povray.text.modes import Mode
from vitrail.lower.povray.text.surface import is_layered


def refuse_nested_layers(asked: Asked, nesting: Nesting, mode: Mode) -> None:
    """Raises NotTranslatable with the place of every such object."""
    found = []
    for index, hosts in enumerate(nesting.hosts):
        material = asked.world.material(index)
        if hosts and any(is_layered(material, exposure) for exposure in mode.exposures):
            what = "POV-Ray cannot show coloured glass that scatters inside other glass, all channels at once"
            remedy = "set reference_mode=channels without --readable, or drop its diffuse share or its colour"
            found.append(asked.refusals.at(what, remedy, "objects", index, "material"))
    if found:
        raise NotTranslatable(found)
