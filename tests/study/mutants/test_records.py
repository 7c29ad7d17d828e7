"""What the confusion matrix and its counts say of three mutants whose fate is known."""

from __future__ import annotations

import pytest

from vitrail.base.phenomenon import Phenomenon
from vitrail.judge.comparison import AblationOutcome
from vitrail.study.mutants.records import AblatedWitness, Alarm, CleanAblations, CleanBench, MutantEntry, Mutants

CAUSTIC, SHADOW, REFRACTION = Phenomenon.CAUSTIC, Phenomenon.SHADOW, Phenomenon.REFRACTION


def mutant(injected: Phenomenon, reported: Phenomenon | None, suspects: tuple[Phenomenon, ...]) -> MutantEntry:
    """A mutant of POV-Ray; SSIM sees it, FLIP does not."""
    outcomes = {"caustic": AblationOutcome.GOES, "shadow": AblationOutcome.STAYS, "glass": AblationOutcome.UNCLEAR}
    return MutantEntry(
        name=f"{injected} as {reported}",
        place="translator",
        what="a mistake",
        injected=injected,
        injected_engine="povray",
        failure=None,
        reported=reported,
        engine="tracer" if reported is SHADOW else "povray" if reported else None,
        where=AblatedWitness(suspects=suspects, ablations=outcomes),
        alone={"ssim": Alarm(caught=True, scenes=("card",)), "flip": Alarm(caught=False, scenes=())},
    )


FOUND = Mutants(
    clean=CleanBench(scenes=("card",), alone={}, ablated=CleanAblations(count=0, apart={})),
    mutants=(
        mutant(CAUSTIC, CAUSTIC, (CAUSTIC,)),
        mutant(CAUSTIC, SHADOW, (SHADOW,)),
        mutant(SHADOW, None, (CAUSTIC, SHADOW)),
    ),
    caught=2,
    named=1,
    located=1,
    cpu_s=1,
)


def test_the_matrix_has_a_column_for_what_escapes() -> None:
    assert FOUND.injected == [CAUSTIC, SHADOW] and FOUND.columns == [CAUSTIC, SHADOW, None]
    counts = [[FOUND.count(row, column) for column in FOUND.columns] for row in FOUND.injected]
    assert counts == [[1, 1, 0], [0, 0, 1]]


def test_an_engine_that_is_blamed_wrongly_counts_as_blamed_alone() -> None:
    assert [entry.reported for entry in FOUND.blamed] == [CAUSTIC, SHADOW]
    assert [entry.reported for entry in FOUND.blamed_right] == [CAUSTIC]


@pytest.mark.parametrize(
    ("suspects", "suspicion"),
    [((CAUSTIC,), "named"), ((CAUSTIC, SHADOW), "among"), ((), "none"), ((SHADOW, REFRACTION), "wrong")],
)
def test_what_the_suspects_are_to_the_injected_phenomenon(suspects: tuple[Phenomenon, ...], suspicion: str) -> None:
    assert mutant(CAUSTIC, CAUSTIC, suspects).suspicion == suspicion


def test_what_was_noticed_and_what_was_switched_off() -> None:
    assert (FOUND.noticed("ssim"), FOUND.noticed("flip"), FOUND.noticed("relmse")) == (3, 0, 0)
    entry = FOUND.mutants[0]
    assert entry.without("goes") == ("caustic",) and entry.without("stays", "unclear") == ("shadow", "glass")
    assert entry.without("not_rendered") == ()
