"""Build the folder a person opens: ``index.html``, one page a scene, scripts with the radiance. Numbers come from
``results.json`` and pixels from the EXR files beside it; nothing is measured here.
"""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

from vitrail.images.exr import read_image
from vitrail.images.false_colour import COLD, HEAT, HOT, NEUTRAL
from vitrail.judge.records import SceneResult, read_results
from vitrail.report import page, paper_figures
from vitrail.report.environment import pages
from vitrail.report.tiles import write_tiles

HERE = Path(__file__).parent
COST_ROWS = (
    ("CPU seconds", "cpu_s", "s"),
    ("of these, photon pass", "photon_cpu_s", "s"),
    ("of these, gather", "gather_cpu_s", "s"),
    ("photons emitted", "photons_emitted", ""),
    ("photons stored", "photons_stored", ""),
    ("photons per CPU second", "photons_per_cpu_s", "/s"),
    ("gathers per CPU second", "gathers_per_cpu_s", "/s"),
)
VIEWS = (
    ("side", "Side by side", "1"),
    ("flip", "Flip", "2"),
    ("slider", "Slider", "3"),
    ("difference", "Difference", "4"),
    ("error", "Visible error", "5"),
)


def build_report(folder: Path) -> Path:
    """Turn ``folder/results.json`` and its images into pages; returns ``folder/index.html``.

    Raises FileNotFoundError without a ``results.json``, ImageError for an image that is named there and cannot be read.
    """
    results = read_results(folder / "results.json")
    shutil.copytree(HERE / "static", folder / "report", dirs_exist_ok=True)
    ordered = page.worst_first(results.scenes)
    plates = paper_figures.plates_of(results)
    index = (
        pages()
        .get_template("index.html")
        .render(
            results=results, scenes=ordered, phenomena=page.run_phenomena(results), has_figures=bool(plates), root=""
        )
    )
    (folder / "index.html").write_text(index, encoding="utf-8")
    # A folder that is used again must not keep the page of an older run.
    (folder / "figures.html").unlink(missing_ok=True)
    if plates:
        text = pages().get_template("figures.html").render(results=results, plates=plates, root="")
        (folder / "figures.html").write_text(text, encoding="utf-8")
    template = pages().get_template("scene.html")
    for place, scene in enumerate(ordered):
        (folder / scene.name).mkdir(exist_ok=True)
        text = template.render(
            results=results,
            scene=scene,
            viewer=_viewer(folder, scene),
            cost_rows=[row for row in COST_ROWS if any(getattr(run, row[1]) is not None for run in scene.engines)],
            previous=ordered[place - 1].name if place > 0 else None,
            next=ordered[place + 1].name if place + 1 < len(ordered) else None,
            root="../",
        )
        (folder / scene.name / "index.html").write_text(text, encoding="utf-8")
    return folder / "index.html"


@dataclass(frozen=True)
class Viewer:
    """What the page's viewer needs: ``data`` for its script, ``views`` to choose from, and the scripts of pixels.

    ``pictures`` are those of observations, by name.
    """

    data: dict[str, object]
    views: list[tuple[str, str, str]]
    layers: list[str]
    sides: list[str]
    scripts: list[str]
    pictures: list[str]


def _viewer(folder: Path, scene: SceneResult) -> Viewer | None:
    """Write the scene's pixels as scripts and return what its viewer needs to know; None without images."""
    if not scene.images:
        return None
    place, has_error = folder / scene.name, "error" in scene.differences
    scripts, layers = [], []
    for image in scene.images:
        pixels = read_image(folder / image.exr)
        scripts += write_tiles(place, image.side, pixels.radiance)
        for layer, array in pixels.layers.items():
            # Layers are loaded by the page when somebody asks for them.
            layers.append((layer, image.side, write_tiles(place, f"{image.side}.{layer}", array)))
    if has_error:
        scripts += write_tiles(place, "error", read_image(folder / scene.differences["error"]).radiance[..., :1])
    sides = [image.side for image in scene.images]
    data: dict[str, object] = {
        "sides": sides,
        "names": {side: page.side_name(side) for side in sides},
        "width": scene.width,
        "height": scene.height,
        "stops": scene.exposure_stops,
        "has_error": has_error,
        "layers": {f"{side}.{layer}": names for layer, side, names in layers},
        "maps": {"heat": HEAT.tolist(), "signed": [COLD.tolist(), NEUTRAL.tolist(), HOT.tolist()]},
        "outlines": {entry.name: entry.patch.outline_px for entry in scene.observations},
    }
    pictures = _pictures(folder, scene)
    data["pictures"] = pictures
    views = [view for view in VIEWS if (view[0] != "error" or has_error) and (len(sides) > 1 or view[0] == "side")]
    names = list(dict.fromkeys(layer for layer, _, _ in layers))
    return Viewer(data, views, names, sides, scripts, list(pictures))


def _pictures(folder: Path, scene: SceneResult) -> dict[str, dict[str, object]]:
    """The pictures of observations by name, with scripts that the page loads when somebody asks for them."""
    found: dict[str, dict[str, object]] = {}
    for view in (entry.view for entry in scene.observations if entry.view is not None):
        if view.name not in found:
            # A name of its own: an observation may be called as a layer is.
            scripts = {
                image.side: write_tiles(
                    folder / scene.name, f"{image.side}.close.{view.name}", read_image(folder / image.exr).radiance
                )
                for image in view.images
            }
            outlines = {entry.name: view.outline_px for entry in scene.observations if entry.view == view}
            found[view.name] = {"width": view.width, "height": view.height, "scripts": scripts, "outlines": outlines}
    return found
