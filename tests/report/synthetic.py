"""A small run made of formulas, so that the report is tested without any engine: three scenes, one of each verdict."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from vitrail.base.phenomenon import Phenomenon
from vitrail.images.display import Display
from vitrail.images.exr import write_image, write_png
from vitrail.images.false_colour import signed_difference
from vitrail.judge.bound import worst
from vitrail.judge.comparison import (
    AblationEntry,
    AblationOutcome,
    Attribution,
    Cause,
    Comparison,
    Curve,
    Interval,
    LayerShare,
    ObservationResult,
    Pair,
    PatchRecord,
    Profile,
    TolerancePart,
    Verdict,
    Whereabouts,
)
from vitrail.judge.exit_code import of_run, of_scene
from vitrail.judge.false_alarms import sidak
from vitrail.judge.records import (
    CertificateEntry,
    EngineRun,
    GlobalMetric,
    ImageFiles,
    PlanEntry,
    Results,
    Run,
    SceneResult,
    Speed,
    Status,
    write_results,
)
from vitrail.judge.scan_records import DifferentPlace, ScanResult
from vitrail.judge.statements import observation_statement, run_statement, scene_headline, scene_statement
from vitrail.judge.verdict import Measured, Noise, decide, overall
from vitrail.judge.view_record import ViewImage, ViewRecord

WIDTH, HEIGHT = 96, 64
OUTLINE = ((24.0, 36.0), (72.0, 36.0), (72.0, 60.0), (24.0, 60.0))


def picture(brightness: float, seed: int) -> np.ndarray:
    """A ring of light on a table, (height, width, 3), with a little noise so that neighbours differ."""
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    radius = np.hypot(x - 48, (y - 48) * 2)
    ring = np.exp(-(((radius - 12) / 3) ** 2))[..., None] * np.array([1.4, 1.2, 0.8]) * brightness
    table = np.where(y[..., None] > 24, 0.2, 0.03) * np.array([1.0, 0.97, 0.92])
    noise = 1 + 0.01 * np.random.default_rng(seed).standard_normal((HEIGHT, WIDTH, 1))
    return (table + ring) * noise


def compared(pair: Pair, metric: str, value: float, error: float, tolerance: float) -> Comparison:
    measured = Measured(pair, metric, "1", value, 1.0, Noise(error, 63, "half images"), settings={"cells": 48})
    part = TolerancePart(source="threshold", amount=tolerance, reason="a number chosen for this test")
    return decide(measured, [part], 0.9998)


def observation(flux: float, error: float, view: ViewRecord | None = None) -> ObservationResult:
    comparisons = (
        compared(Pair.TRACER_POVRAY, "flux_ratio.red", flux, error, 0.02),
        compared(Pair.TRACER_POVRAY, "profile_correlation", 0.999, 0.0, 0.01),
        compared(Pair.TRACER_TRUTH, "caustic_flux", flux * 0.998, error, 0.02),
        compared(Pair.POVRAY_TRUTH, "caustic_flux", 1.001, 0.001, 0.03),
    )
    verdict = overall(entry.verdict for entry in comparisons)
    positions = np.linspace(-0.02, 0.02, 48)
    curve = np.exp(-((np.abs(positions) - 0.01) ** 2) / 1e-5)
    profile = Profile(
        along="u",
        channel="luminance",
        unit="W sr⁻¹ m⁻²",
        positions_m=tuple(positions.tolist()),
        curves=(
            Curve(side="tracer", values=tuple((curve * flux).tolist()), standard_error=tuple([0.03] * 48)),
            Curve(side="povray", values=tuple((curve * 1.001).tolist())),
            Curve(side="truth", values=tuple(curve.tolist())),
        ),
    )
    cause = Attribution(
        cause=Cause.MODEL, engine="tracer", reason="POV-Ray agrees with the closed form, the tracer does not"
    )
    return ObservationResult(
        name="ring",
        phenomenon=Phenomenon.CAUSTIC,
        patch=PatchRecord(center=(0, 0, 0), u=(0.02, 0, 0), v=(0, 0, 0.01), outline_px=OUTLINE),
        view=view,
        comparisons=comparisons,
        profiles=(profile,),
        verdict=verdict or comparisons[0].verdict,
        bound=worst(comparisons),
        statement=observation_statement(Phenomenon.CAUSTIC, comparisons),
        attribution=cause if verdict == "deviates" else None,
        where=whereabouts(flux) if verdict == "deviates" else None,
    )


def whereabouts(flux: float) -> Whereabouts:
    """One thing whose absence mends the flux, and one that was too dear."""
    gone = AblationEntry(
        off="caustic", words="bodies that mirror or refract are black", outcome=AblationOutcome.GOES,
        metric="flux_ratio.red", unit="1", before=flux - 1, after=0.002,
        interval=Interval(low=-0.001, high=0.005, level=0.9998, method="exact"),
        absent=(Phenomenon.CAUSTIC,), touched=(Phenomenon.CAUSTIC,),
    )  # fmt: skip
    dear = AblationEntry(
        off="refraction", words="glass has index 1 and bends nothing", outcome=AblationOutcome.NOT_RENDERED,
        reason="about 9 CPU s each, and 2 are left; --budget-s bounds it",
        absent=(Phenomenon.REFRACTION,), touched=(Phenomenon.REFRACTION,),
    )  # fmt: skip
    layers = (LayerShare(layer=Phenomenon.CAUSTIC, channel="red", share=0.5, acts_on=0.5, needed=0.46),)
    reason = "in caustic: it goes when bodies that mirror or refract are black"
    return Whereabouts(suspects=(Phenomenon.CAUSTIC,), reason=reason, ablations=(gone, dear), layers=layers)


def close_up(place: Path, flux: float) -> ViewRecord:
    """Write the pictures of the ring alone, of both sides and their difference, and return their record."""
    shown, sides = (slice(30, 62), slice(24, 72)), []
    pictures = {"tracer": picture(flux, 0)[shown], "povray": picture(1.0, 1)[shown]}
    for side, radiance in pictures.items():
        write_image(place / f"{side}.ring.exr", radiance)
        write_png(place / f"{side}.ring.png", Display().apply(radiance))
        sides.append(ViewImage(side=side, exr=f"{place.name}/{side}.ring.exr", png=f"{place.name}/{side}.ring.png"))
    difference = signed_difference(pictures["tracer"], pictures["povray"], scale=0.1)
    write_png(place / "difference.ring.png", difference)
    return ViewRecord(
        name="ring",
        kind="perspective",
        position=(0.0, 0.1, 0.2),
        look_at=(0.0, 0.0, 0.0),
        up=(0.0, 1.0, 0.0),
        fov_deg=9.5,
        width=48,
        height=32,
        samples=4,
        images=tuple(sides),
        difference_picture=f"{place.name}/difference.ring.png",
    )


def scanned(place: Path, flux: float) -> ScanResult:
    """A scan of the whole picture; where the flux is far off it found a place beside the patch."""
    write_png(place / "over_noise.png", signed_difference(picture(flux, 0), picture(1.0, 1), scale=0.1))
    words = "outside the patches: 40 pixels at the upper left, on `wall`, are 1.7 times brighter in the tracer"
    found = DifferentPlace(
        x_px=12, y_px=8, width_px=10, height_px=4, pixels=40, object="wall", layer="caustic", tracer=0.004,
        povray=0.0024, tolerance=0.0001, standard_error=2e-5, excess=75.0, deviates=True, words=words,
    )  # fmt: skip
    return ScanResult(
        threshold=6.5,
        false_alarm_rate=0.001,
        picture=f"{place.name}/over_noise.png",
        places=(found,) if flux > 1.2 else (),
        verdict=Verdict.DEVIATES if flux > 1.2 else Verdict.AGREES,
    )


def scene(folder: Path, name: str, title: str, flux: float, error: float) -> SceneResult:
    """Write the pictures of one scene and return its record."""
    place = folder / name
    place.mkdir()
    images = []
    for seed, (side, brightness) in enumerate((("tracer", flux), ("povray", 1.0))):
        radiance = picture(brightness, seed)
        write_image(place / f"{side}.exr", radiance, layers={"caustic": radiance * 0.5} if side == "tracer" else None)
        write_png(place / f"{side}.png", Display().apply(radiance))
        images.append(ImageFiles(side=side, exr=f"{name}/{side}.exr", png=f"{name}/{side}.png", content=f"{seed:064d}"))
    error_map = np.abs(picture(flux, 0) - picture(1.0, 1))
    write_image(place / "error.exr", error_map)
    observed = observation(flux, error, close_up(place, flux))
    engines = tuple(
        EngineRun(engine=engine, version=version, cpu_s=cpu, photon_cpu_s=cpu / 2, gather_cpu_s=cpu / 4,
                  photons_emitted=100_000, photons_per_cpu_s=2e5 / cpu, settings={"seed": 1},
                  record={"vitrail_run": 1, "threads": 1, "ledger": {"closure": 1e-12}})
        for engine, version, cpu in (("tracer", "0.1.0", 0.21), ("povray", "3.7.0.10", 2.2))
    )  # fmt: skip
    return SceneResult(
        name=name,
        title=title,
        source=f"scenes/{name}.yaml",
        scene_hash="0123456789abcdef" * 4,
        status=Status.JUDGED,
        width=WIDTH,
        height=HEIGHT,
        plan=(
            PlanEntry(phenomenon=Phenomenon.CAUSTIC, required=True, evidence=("sun -> ball",), cost="1e5 photons"),
            PlanEntry(phenomenon=Phenomenon.DISPERSION, required=False, evidence=("no material disperses",)),
        ),
        settings={"samples": 4, "gather_radius_m": 0.01},
        certificate=(
            CertificateEntry(phenomenon=Phenomenon.CAUSTIC, item="sun", source_law="E / pi", target_law="E / pi",
                             residual=5e-4, unit="relative", reason="half-float output"),
        ),
        engines=engines,
        speed=(Speed(phase="photon pass", ratio=10.5, unit="photons per CPU second"),),
        images=tuple(images),
        differences={"error": f"{name}/error.exr"},
        global_metrics=(GlobalMetric(metric="ssim", value=0.987, unit="1", ideal=1.0, settings={"data_range": 1.0}),),
        observations=(observed,),
        scan=scanned(place, flux),
        reproduce=f"vitrail compare scenes/{name}.yaml --out out --quality draft --seed 1",
        verdict=observed.verdict,
        bound=observed.bound,
        statement=scene_statement([observed], scanned(place, flux)),
        headline=scene_headline([observed]),
        exit_code=of_scene(Status.JUDGED, observed.verdict),
    )  # fmt: skip


def write_run(folder: Path) -> Results:
    """A run with one scene of each verdict and one that could not be rendered, written with its images."""
    failed = SceneResult(
        name="broken",
        title="POV-Ray stopped",
        source="scenes/broken.yaml",
        status=Status.ENGINE_FAILED,
        message="povray: Parse Error: Expected 'numeric expression', } found instead",
        exit_code=of_scene(Status.ENGINE_FAILED, None),
    )
    scenes = (
        scene(folder, "alike", "A ring that agrees", 1.004, 0.001),
        scene(folder, "apart", "A ring that is too bright", 1.3, 0.002),
        scene(folder, "unsure", "A ring in noise", 1.01, 0.006),
        failed,
    )
    counts = {"unjudged": 1, "deviates": 1, "inconclusive": 1, "agrees": 1}
    results = Results(
        run=Run(vitrail_version="0.1.0", started="2026-01-02 03:04", processor="one core"),
        false_alarms=sidak(0.01, 12),
        scenes=scenes,
        counts=counts,
        statement=run_statement(counts),
        verdict=overall(entry.verdict for entry in scenes),
        exit_code=of_run(entry.exit_code for entry in scenes),
    )
    write_results(results, folder / "results.json")
    return results


def write_paper_run(folder: Path) -> Results:
    """A run with some of the paper's figures, not in the paper's order, and a scene that is none of them."""
    order = ("figure_8", "figure_5", "other", "figure_7", "figure_6", "figure_1")
    settings = {"samples": 4, "photons": 100_000, "rough_samples": 1}
    scenes = tuple(
        scene(folder, name, name.replace("_", " "), 1.3 if name == "figure_1" else 1.004, 0.001).model_copy(
            update={"settings": settings}
        )
        for name in order
    )
    results = Results(
        run=Run(vitrail_version="0.1.0", started="2026-01-02 03:04"),
        false_alarms=sidak(0.01, 24),
        scenes=scenes,
        counts={"deviates": 1, "agrees": 5},
        verdict=overall(entry.verdict for entry in scenes),
        exit_code=of_run(entry.exit_code for entry in scenes),
    )
    write_results(results, folder / "results.json")
    return results
