"""POV-Ray text shared by the atlas's hand-written scenes."""

from __future__ import annotations

from vitrail.base.vector import Vec


def header(photons: str = "") -> str:
    """Settings that switch off every limit a user can switch off, so that what fails is the program's own."""
    block = f" photons {{ {photons} }}" if photons else ""
    return (
        f"#version 3.7;\nglobal_settings {{ assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30{block} }}\n"
        "#default { finish { ambient 0 emission 0 diffuse 0 } }\n"
    )


def vector(value: Vec) -> str:
    return "<" + ",".join(repr(float(component)) for component in value) + ">"


def orthographic(location: Vec, direction: Vec, right: Vec, up: Vec, size: float) -> str:
    """A camera that sees a square of ``size``."""
    edge_right = tuple(size * component for component in right)
    edge_up = tuple(size * component for component in up)
    return (
        f"camera {{ orthographic location {vector(location)} direction {vector(direction)}"
        f" right {vector(edge_right)} up {vector(edge_up)} }}\n"  # type: ignore[arg-type]
    )


def glowing_plane(axis: str, distance: float, radiance: float = 1.0) -> str:
    return f"plane {{ {axis},{distance!r} pigment {{ rgb {radiance!r} }} finish {{ emission 1 }} }}\n"


CLEAR = "pigment { rgb 1 filter 1 }"
FRESNEL = "finish { reflection { 0,1 fresnel on } conserve_energy }"
