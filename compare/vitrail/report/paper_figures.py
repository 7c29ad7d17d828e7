"""The figures of *Spectrum of Glass Rendering* in the paper's order: what each shows, and with which numbers.

The words are about the paper; the pictures and the numbers of agreement come from the run that rendered the scenes of
``scenes/paper``. A plate is one entry of the page: a figure, or the three of the paper that are one series.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath

from vitrail.judge.comparison import Comparison, ObservationResult
from vitrail.judge.records import Results, SceneResult
from vitrail.report.page import furthest_off


@dataclass(frozen=True)
class Plate:
    """``scenes`` by their files' stems with the words over each column; ``given`` is what the paper prints."""

    number: str
    title: str
    scenes: Mapping[str, str]
    given: str
    taken: str
    look: tuple[str, ...]


PLATES = (
    Plate(
        "Figure 1",
        "Glass that also scatters",
        {"figure_1": ""},
        "One glass sphere and one red specular sphere; the glass has diffusion 0.1, reflection 0.1, refraction 0.8.",
        "Room, lamp and index (1.5) are ours; the paper prints none.",
        (
            "a grey veil over the whole ball: light that its surface scatters",
            "the room upside down behind the veil, and the caustic in the shadow below",
        ),
    ),
    Plate(
        "Figure 2",
        "Glass that only refracts",
        {"figure_2": ""},
        "The same spheres; the glass has diffusion 0, reflection 0.01, refraction 0.99.",
        "Room, lamp and index as in figure 1.",
        ("the veil is gone: walls and floor stand clear and upside down in the ball", "a slightly brighter caustic"),
    ),
    Plate(
        "Figure 3",
        "The caustic",
        {"figure_3": ""},
        "The same spheres, with a refraction index that is “high enough”.",
        "Index 1.7, at the edge of impure crown and flint in the paper's table; materials as in figure 2.",
        ("the light is drawn together to a smaller, brighter spot than in figure 2, in the middle of the shadow",),
    ),
    Plate(
        "Figure 4",
        "Coloured transmission",
        {"figure_4": ""},
        "Transmissive material on the right wall, the projected caustic on the left wall; one area light that sends "
        "all its photons along its normal.",
        "Four panes, each with its refraction colour; the ambient light is the constant that the paper allows.",
        (
            "four coloured fields on the left wall, with sharp edges because the light is collimated",
            "the bars between the panes as shadows; the panes themselves dark, because nothing lies behind them",
        ),
    ),
    Plate(
        "Figures 5, 6, 7",
        "Roughness over samples",
        {
            "figure_5": "5: no antialiasing, one ray",
            "figure_6": "6: antialiasing, one ray",
            "figure_7": "7: antialiasing, three rays",
        },
        "Increasing roughness λ from left to right; without antialiasing and one convoluted ray at each face, then "
        "with antialiasing, then with antialiasing and three rays.",
        "λ is 0, 0.1, 0.3 and 0.5; the paper prints no values.",
        (
            "from ball to ball: the squares behind the glass dissolve",
            "from figure to figure: the same blur with less grain",
            "POV-Ray's rough glass is an average over bumped faces, with no rays to count: its figures 6 and 7 are one",
        ),
    ),
    Plate(
        "Figure 8",
        "Dispersion",
        {"figure_8": ""},
        "Light through a prism of index 1.6 and distribution 0.032: four colours with 1.600, 1.632, 1.664 and 1.696.",
        "An apex of 60° and a beam at 55° to the face, which the paper does not print.",
        (
            "four bands on the screen, red, yellow, green, blue from the least turned to the most",
            "the beam is so wide that the bands overlap, and there their colours mix",
        ),
    ),
)


@dataclass(frozen=True)
class ShownPlate:
    """A plate with the scenes of a run: ``columns`` with the words over each, ``rows`` the makers of the pictures."""

    plate: Plate
    columns: list[tuple[str, SceneResult]]
    rows: list[str]


def plates_of(results: Results) -> list[ShownPlate]:
    """The plates of which a run has a scene, each with its scenes in the paper's order; nothing for other runs."""
    found = {PurePosixPath(scene.source).stem: scene for scene in results.scenes}
    plates = []
    for plate in PLATES:
        columns = [(words, found[stem]) for stem, words in plate.scenes.items() if stem in found]
        if columns:
            plates.append(ShownPlate(plate, columns, _sides([scene for _, scene in columns])))
    return plates


def _sides(scenes: Sequence[SceneResult]) -> list[str]:
    """The makers of the pictures, each a row."""
    return list(dict.fromkeys(image.side for scene in scenes for image in scene.images))


def agreement(observation: ObservationResult) -> list[Comparison]:
    """One number a metric, between the engines: of its channels and directions the one that is furthest off."""
    between = [entry for entry in observation.comparisons if entry.pair.value == "tracer-vs-povray"]
    families: dict[str, list[Comparison]] = {}
    for entry in between:
        families.setdefault(entry.metric.split(".")[0], []).append(entry)
    return [furthest_off(entries) for entries in families.values()]
