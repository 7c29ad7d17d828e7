"""The declared matrix: which settings of which engine are tried on a scene, and why.

Only knobs that the plan gives a meaning are turned. The *main* knobs, which buy accuracy, are tried in every
combination: photons and gather radius where there is a caustic, else samples a pixel; with light bins, which have no
radius, photons and size of the image, and with beams, which have no blur, photons. Every other knob is turned by itself
from the middle of those: samples, depth, bands, and POV-Ray's reference modes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Literal

from vitrail.base.engine_name import EngineName
from vitrail.base.phenomenon import Phenomenon
from vitrail.lower.povray.text.modes import mode_of
from vitrail.pipeline.job import Job, prepare
from vitrail.plan.plan import Plan
from vitrail.plan.settings import Quality

Extent = Literal["quick", "normal", "wide"]

KnobValue = int | float | str | dict[str, int]
"""A number, a name, or one that takes a number: ``{"spectral": 8}``."""

KnobValues = Mapping[str, KnobValue]

ENGINES = tuple(EngineName)

PHOTONS: Mapping[Extent, Mapping[EngineName, tuple[int, ...]]] = {
    "quick": {EngineName.TRACER: (10_000, 100_000, 1_000_000), EngineName.POVRAY: (10_000, 100_000)},
    "normal": {engine: (10_000, 40_000, 160_000, 640_000, 2_560_000) for engine in ENGINES},
    "wide": {engine: (10_000, 40_000, 160_000, 640_000, 2_560_000, 10_240_000) for engine in ENGINES},
}
RADII: Mapping[Extent, tuple[float, ...]] = {"quick": (1.0, 0.5), "normal": (1.0, 0.5, 0.25), "wide": (2, 1, 0.5, 0.25)}
"""Gather radius over the one the budget chooses for a million photons."""

SCALES: Mapping[Extent, tuple[int, ...]] = {"quick": (1, 2), "normal": (1, 2, 4), "wide": (1, 2, 4)}
"""Width and height of the image over those the scene asks for: a pixel blurs what it sees as much as a gather disc."""

SAMPLES: Mapping[Extent, tuple[int, ...]] = {"quick": (1, 4), "normal": (1, 4, 16), "wide": (1, 4, 16, 64)}
BANDS: Mapping[Extent, tuple[KnobValue, ...]] = {
    "quick": ("paper", {"spectral": 8}),
    "normal": ("paper", {"spectral": 8}, {"spectral": 32}),
    "wide": ("paper", "povray", {"spectral": 8}, {"spectral": 32}),
}
DEPTHS: tuple[int, ...] = (2, 4, 8)
MODES = ("native", "channels", "slices")
SEEDS: Mapping[Extent, int] = {"quick": 2, "normal": 3, "wide": 5}
"""Runs of each setting. POV-Ray has no seed: its runs give one image, and tell how its cost scatters."""


@dataclass(frozen=True)
class Knobs:
    """One setting of one engine. ``settings`` override the budget, ``wishes`` what the scene asks for: its transport,
    and ``image_scale`` times its width and height."""

    engine: EngineName
    settings: KnobValues
    wishes: KnobValues
    seed: int

    @property
    def label(self) -> str:
        """The setting without its seed, for a table or a point of a chart."""
        return label_of({**self.settings, **self.wishes})


UNITS = {"gather_radius_m": ("gather radius", 1e3, " mm")}


def label_of(parts: KnobValues) -> str:
    """Knobs as a person reads them: ``photons 10 000, gather radius 6.84 mm``, which says that a disc gathers."""
    named = sorted((name for name in parts if parts[name] != "photon_map"), key=lambda name: (name != "photons", name))
    return ", ".join(_knob(name, parts[name]) for name in named)


def _knob(name: str, value: KnobValue) -> str:
    words, scale, unit = UNITS.get(name, (name.replace("_", " "), 1.0, ""))
    return f"{words} {_short(value * scale if scale != 1.0 and isinstance(value, int | float) else value)}{unit}"


Point = tuple[KnobValues, KnobValues]
"""Settings and wishes of one point of the matrix."""


def matrix(usual: Job, extent: Extent) -> list[Knobs]:
    """Every setting to try, each engine by itself; each setting once. ``usual`` has the usual photons and radius."""
    found: dict[str, Knobs] = {}
    for engine in ENGINES:
        main = _main(usual.plan, usual.settings.gather_radius_m, extent, engine)
        tried = main + list(_around(_middle(main), usual, extent, engine))
        for (settings, wishes), seed in product(tried, range(1, 1 + SEEDS[extent])):
            knobs = Knobs(engine, settings, wishes, seed)
            found.setdefault(f"{engine} {seed} {knobs.label}", knobs)
    return list(found.values())


def _main(plan: Plan, radius_m: float, extent: Extent, engine: EngineName) -> list[Point]:
    """Photons and radius for a caustic, samples a pixel for anything else; cheap ones first."""
    if not plan.requires(Phenomenon.CAUSTIC):
        return [({"samples": samples}, {}) for samples in SAMPLES[extent]]
    photons, radii = PHOTONS[extent][engine], RADII[extent]
    usual: KnobValues = {"samples": 1} | ({"solver": "photon_map"} if engine is EngineName.TRACER else {})
    found: list[Point] = [
        ({**usual, "photons": n, "gather_radius_m": radius_m * share}, {}) for n, share in product(photons, radii)
    ]
    # The smallest disc is narrower than a pixel: give it pixels to match.
    found += [({**usual, "photons": n, "gather_radius_m": radius_m * min(radii)}, _larger(2)) for n in photons]
    if engine is EngineName.TRACER:
        bins = product(photons, SCALES[extent])
        found += [({"samples": 1, "photons": n, "solver": "light_bins"}, _larger(scale)) for n, scale in bins]
        # Beams end below every other error long before the most photons, and their rays are dear.
        found += [({"samples": 1, "photons": n, "solver": "beams"}, {}) for n in photons[:-1]]
    return found


def amount(values: KnobValues, knob: str) -> float:
    """How much work a knob of work (photons, samples) asks for."""
    value = values[knob]
    if not isinstance(value, int | float):
        raise TypeError(f"{knob} is {value!r}, which is no amount of work")
    return float(value)


def _larger(scale: int) -> KnobValues:
    return {"image_scale": scale} if scale != 1 else {}


def _middle(main: list[Point]) -> KnobValues:
    """The first setting of the middle photon count, or of the middle number of samples."""
    work = [amount(settings, "photons" if settings.get("photons") else "samples") for settings, _ in main]
    steps = sorted(set(work))
    return main[work.index(steps[(len(steps) - 1) // 2])][0]


def _around(middle: KnobValues, usual: Job, extent: Extent, engine: EngineName) -> Iterator[Point]:
    """Every other knob that has a meaning here, turned by itself."""
    plan, own = usual.plan, usual.scene.transport.model_dump()
    if plan.requires(Phenomenon.CAUSTIC):
        yield from (({**middle, "samples": samples}, {}) for samples in SAMPLES[extent])
    if plan.requires(Phenomenon.DISPERSION):
        yield from ((middle, {"bands": each}) for each in BANDS[extent] if each != own["bands"])
    if not plan.chain.proven:
        wish = "max_reflections" if plan.requires(Phenomenon.REFLECTION) else "max_transmissions"
        yield from ((middle, {wish: depth}) for depth in DEPTHS if depth != own[wish])
    if engine is EngineName.POVRAY:
        yield from (({**middle, "reference_mode": mode}, {}) for mode in _different_modes(usual))


def _different_modes(usual: Job) -> list[str]:
    """The reference modes that do other work on this scene than the usual one, each work once."""
    found: dict[tuple[int, bool], str] = {}
    for name in ("auto", *MODES):
        # An image of the sky counts as grey here: what it is costs a file, and at most one knob more.
        job = prepare(usual.loaded, Quality.NORMAL, {"reference_mode": name})
        mode = mode_of(job.scene, job.plan, job.settings, {})
        found.setdefault((len(mode.exposures), mode.is_sliced), name)
    return [name for name in found.values() if name != "auto"]


def _short(value: KnobValue) -> str:
    if isinstance(value, float):
        return f"{value:.3g}"
    if isinstance(value, int):
        return f"{value:,}".replace(",", "\u2009")
    if isinstance(value, dict):
        return " ".join(f"{name} {each}" for name, each in value.items())
    return str(value).replace("_", " ")
