"""Hypothesis strategies for scenes: every type of the language, within what its own types allow."""

from __future__ import annotations

from typing import Any, get_args

from hypothesis import strategies as st

from vitrail.base.phenomenon import Phenomenon
from vitrail.scene import model

numbers = st.floats(-1e6, 1e6, allow_nan=False).map(lambda value: value + 0.0)
positive = st.floats(1e-6, 1e6)
fractions = st.floats(0, 1)
vectors = st.tuples(numbers, numbers, numbers)
axes = st.sampled_from([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.6, 0.8, 0.0), (-0.8, 0.0, 0.6)])
light = st.floats(0, 1e6)
colours = st.one_of(light.map(lambda value: (value,) * 3), st.tuples(light, light, light))
thirds = st.floats(0, 1 / 3)
shares = st.one_of(thirds.map(lambda value: (value,) * 3), st.tuples(thirds, thirds, thirds))
names = st.text(st.characters(codec="utf-8"), min_size=1, max_size=8).filter(lambda text: text.strip() != "")


def optional(strategy: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return st.one_of(st.none(), strategy)


def checkers(colour: st.SearchStrategy[Any]) -> st.SearchStrategy[model.Checker]:
    squares = st.builds(model.CheckerSquares, colors=st.tuples(colour, colour), size=positive)
    return st.builds(model.Checker, checker=squares)


def edges() -> st.SearchStrategy[tuple[Any, Any]]:
    """Two perpendicular half edges."""
    pairs = [
        ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
        ((0.6, 0.8, 0.0), (-0.8, 0.6, 0.0)),
        ((0.0, 0.0, 2.0), (0.5, 0.0, 0.0)),
    ]
    return st.sampled_from(pairs)


rectangles = st.builds(lambda center, uv: model.Rectangle(center=center, u=uv[0], v=uv[1]), vectors, edges())
discs = st.builds(model.Disc, center=vectors, normal=axes, radius=positive)
cylinders = st.builds(
    lambda start, axis, radius: model.Cylinder(
        **{"from": start, "to": tuple(a + b for a, b in zip(start, axis, strict=True)), "radius": radius}
    ),
    st.tuples(*[st.floats(-100, 100)] * 3),
    axes,
    positive,
)
cones = st.builds(
    lambda cylinder, ratio: model.Cone(
        **{
            "from": cylinder.from_,
            "to": cylinder.to,
            "radius_from": cylinder.radius,
            "radius_to": ratio * cylinder.radius,
        }
    ),
    cylinders,
    st.floats(0, 0.99),
)
boxes = st.builds(
    lambda low, size: model.Box(min=low, max=tuple(a + b for a, b in zip(low, size, strict=True))),
    vectors,
    st.tuples(*[st.floats(1e-3, 10)] * 3),
)
prisms = st.one_of(
    st.builds(model.Prism, height=positive, apex_deg=st.floats(1, 179), side=positive),
    st.builds(model.Prism, height=positive, profile=st.lists(st.tuples(numbers, numbers), min_size=3).map(tuple)),
)
lenses = st.builds(model.Lens, radius_front=numbers, radius_back=numbers, thickness=positive, diameter=positive)
tori = st.builds(
    lambda center, normal, radius, share: model.Torus(
        center=center, normal=normal, radius=radius, radius_tube=share * radius
    ),
    vectors,
    axes,
    positive,
    st.floats(0.01, 0.99),
)
turned = st.tuples(st.floats(0, 10), numbers)
lathes = st.builds(model.Lathe, profile=st.lists(turned, min_size=3).map(tuple))
SHAPES = {
    "sphere": st.builds(model.Sphere, center=vectors, radius=positive),
    "plane": st.builds(model.Plane, point=vectors, normal=axes),
    "rectangle": rectangles,
    "disc": discs,
    "box": boxes,
    "cylinder": cylinders,
    "cone": cones,
    "prism": prisms,
    "lens": lenses,
    "torus": tori,
    "lathe": lathes,
    "mesh": st.builds(model.Mesh, file=names, smooth=st.booleans()),
}
EMITTERS = {
    "directional": st.builds(
        model.Directional, direction=axes, irradiance=colours, angular_diameter_deg=st.floats(0, 89)
    ),
    "point": st.builds(model.Point, position=vectors, intensity=colours),
    "spot": st.builds(model.Spot, position=vectors, direction=axes, intensity=colours, cone_deg=st.floats(1, 179)),
    "area": st.one_of(
        st.builds(model.Area, shape=rectangles, radiance=colours),
        st.builds(model.Area, shape=discs, collimated=st.just(True), irradiance=colours),
    ),
    "environment": st.one_of(st.builds(model.Environment, radiance=colours), st.builds(model.Environment, file=names)),
}

glass_materials = st.builds(
    model.Material,
    diffuse=shares,
    reflection=shares,
    transmission=shares.filter(lambda colour: max(colour) > 0),
    ior=st.floats(0.5, 4),
    fresnel=st.booleans(),
    roughness=st.one_of(fractions, st.builds(model.Ggx, ggx=st.floats(1e-3, 1))),
    dispersion=st.one_of(st.none(), st.floats(-0.1, 0.1), st.builds(model.Abbe, abbe=st.floats(10, 90))),
    attenuation=optional(st.builds(model.Attenuation, color=st.tuples(*[st.floats(1e-3, 1)] * 3), distance=positive)),
    emission=optional(st.one_of(colours, checkers(colours))),
)
catalogue_materials = st.builds(
    model.Material,
    transmission=st.just((1.0, 1.0, 1.0)),
    glass=st.sampled_from(get_args(model.Glass)),
    absorption_per_m=optional(colours),
)
opaque_materials = st.builds(model.Material, diffuse=st.one_of(shares, checkers(shares)), reflection=shares)
materials = st.one_of(glass_materials, catalogue_materials, opaque_materials)

cameras = st.builds(
    lambda position, view, up, rest: model.Camera(
        position=position, look_at=tuple(a + b for a, b in zip(position, view, strict=True)), up=up, **rest
    ),
    st.tuples(*[st.floats(-100, 100)] * 3),
    st.sampled_from([(0.0, 0.0, -1.0), (0.0, 0.3, -5.0)]),
    st.sampled_from([(0.0, 1.0, 0.0), (1.0, 1.0, 0.0)]),
    st.one_of(
        st.builds(lambda angle: {"fov_deg": angle}, st.floats(1, 179)),
        st.builds(lambda height: {"kind": "orthographic", "height": height}, positive),
    ),
)
images = st.builds(
    model.Image, width=st.integers(1, 16384), height=st.integers(1, 16384), exposure_stops=st.floats(-20, 20)
)
transports = st.builds(
    model.Transport,
    indirect=st.one_of(st.sampled_from(["none", "photons"]), st.builds(model.Ambient, ambient=colours)),
    max_reflections=st.integers(0, 1000),
    max_transmissions=st.integers(0, 1000),
    bands=st.one_of(
        st.sampled_from(["paper", "povray", "continuous"]),
        st.builds(model.SpectralBands, spectral=st.integers(2, 256)),
    ),
)
papers = st.builds(
    model.Paper,
    tir=st.sampled_from(["reflect", "drop"]),
    refraction=st.sampled_from(["corrected", "literal"]),
    literal_sum=st.booleans(),
    dispersion=st.sampled_from(["step", "span"]),
    dispersion_reference=st.sampled_from(["red", "d_line", "middle"]),
    disperse_camera=st.booleans(),
    rough_samples=st.integers(1, 256),
    rough_photons=st.sampled_from(["reciprocal", "literal"]),
)
patches = st.builds(lambda center, uv: model.Patch(center=center, u=uv[0], v=uv[1]), vectors, edges())


@st.composite
def scenes(draw: st.DrawFn) -> model.Scene:
    """Any scene that the types allow, sense or not."""
    available = draw(st.dictionaries(names, materials, min_size=1, max_size=4))
    pick = st.sampled_from(sorted(available))
    objects = []
    for name in draw(st.lists(names, unique=True, max_size=4)):
        key = draw(st.sampled_from(sorted(SHAPES)))
        rest = {
            "rotate_deg": draw(vectors),
            "translate": draw(vectors),
            "priority": draw(optional(st.integers(0, 1000))),
        }
        objects.append(model.Object(name=name, material=draw(pick), shape=draw(SHAPES[key]), **rest))
    lights = []
    for name in draw(st.lists(names, unique=True, max_size=3)):
        key = draw(st.sampled_from(sorted(EMITTERS)))
        lights.append(model.Light(name=name, emitter=draw(EMITTERS[key])))
    observe = [
        model.Observation(
            name=name,
            phenomenon=draw(st.sampled_from(list(Phenomenon))),
            patch=draw(patches),
            along=draw(st.sampled_from([None, "u", "v"])),
            pattern=draw(optional(names)),
        )
        for name in draw(st.lists(names, unique=True, max_size=3))
    ]
    return model.Scene(
        vitrail=1,
        title=draw(st.text(st.characters(codec="utf-8"), max_size=20)),
        camera=draw(cameras),
        image=draw(images),
        materials=available,
        objects=tuple(objects),
        lights=tuple(lights),
        transport=draw(transports),
        paper=draw(papers),
        observe=tuple(observe),
    )
