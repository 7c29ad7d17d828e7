"""Where a deviation lives, in a sentence for people."""

from __future__ import annotations

from collections.abc import Sequence

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import AblationEntry, AblationOutcome, LayerShare
from vitrail.judge.patch_light import is_too_weak

BENEATH = "what is beneath all of it (light, surfaces, camera, units)"
"""What diffusion stands for: what every scene has."""


def sentence(
    suspects: Sequence[Phenomenon],
    entries: Sequence[AblationEntry],
    layers: Sequence[LayerShare],
    required: frozenset[Phenomenon],
) -> str:
    """The suspects and why, then what told nothing and what was not tried."""
    told = [
        _clause(entries, outcome, verb)
        for outcome, verb in ((AblationOutcome.GOES, "goes"), (AblationOutcome.STAYS, "stays"))
    ]
    why = ", and ".join(clause for clause in told if clause)
    if not why:
        why = "the scene requires nothing else" if required <= {Phenomenon.DIFFUSION} else "nothing was told apart"
    parts = [f"{_names(suspects)}: {why}"]
    weak = [each for each in layers if is_too_weak(each) and each.layer not in suspects]
    parts += [
        f"{_name(each.layer)} acts on {100 * each.acts_on:.2g} % of the light, which is too little" for each in weak
    ]
    unclear = [each for each in entries if each.outcome is AblationOutcome.UNCLEAR]
    parts += [f"when {each.words} it is unclear ({each.reason})" for each in unclear]
    missing = [each for each in entries if each.outcome is AblationOutcome.NOT_RENDERED]
    if missing:
        parts.append(f"not tried: {', '.join(each.off for each in missing)} ({missing[0].reason})")
    return "; ".join(parts)


def _names(suspects: Sequence[Phenomenon]) -> str:
    """One name, several, or none."""
    if not suspects:
        return "in no single phenomenon"
    names = [BENEATH if each is Phenomenon.DIFFUSION else _name(each) for each in suspects]
    if len(names) == 1:
        return f"in {names[0]}"
    return f"in {', '.join(names[:-1])} or {names[-1]}, which were not told apart"


def _clause(entries: Sequence[AblationEntry], outcome: AblationOutcome, verb: str) -> str:
    found = [each.words for each in entries if each.outcome is outcome]
    return f"it {verb} when {' and when '.join(found)}" if found else ""


def _name(phenomenon: Phenomenon) -> str:
    return phenomenon.value.replace("_", " ")
