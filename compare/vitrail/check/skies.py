"""What the image of a sky holds: radiance in every pixel, or no sky at all."""

from __future__ import annotations

from vitrail.check.files import file_problem
from vitrail.check.findings import Findings


def check_sky(findings: Findings, index: int, name: str) -> None:
    """Refuse the file ``name`` of light ``index`` unless it can be read and is radiance in every pixel."""
    path = ("lights", index, "environment", "file")
    if not name.lower().endswith(".exr"):
        findings.error(f"`{name}` is not an EXR image", "give a lat-long image that ends in .exr", *path)
    elif (problem := file_problem(findings, name)) is not None:
        findings.error(problem, "paths are relative to the scene file; check this one", *path)
    else:
        _check_radiance(findings, name, path)


def _check_radiance(findings: Findings, name: str, path: tuple[str | int, ...]) -> None:
    # Images take long to import, and few scenes have one.
    from vitrail.images.exr import ImageError
    from vitrail.images.sky import read_sky

    file = findings.loaded.path.parent / name
    try:
        read_sky(file)
    except ImageError as error:
        findings.error(f"the sky `{name}` {error.what}", error.remedy, *path)
