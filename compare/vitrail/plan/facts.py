"""What the analysis knows about a scene before it decides anything: who is seen, who is lit, which paths there are."""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.geometry.world import World
from vitrail.optics.bands import ALL_LIGHT, Band, band_model
from vitrail.optics.dispersion import ior_by_band
from vitrail.plan.chains import longest_chain
from vitrail.plan.lever import Lever, lever_on, lever_through
from vitrail.plan.light_paths import caustic_paths, directly_visible, specular_objects, visible
from vitrail.plan.light_reach import is_lit
from vitrail.plan.plan import CausticPath, Chain
from vitrail.scene.model import Light, Material, Object, Scene


@dataclass(frozen=True)
class Facts:
    """Who takes part in the picture.

    ``direct``: may be in the picture. ``seen``: may be seen, directly or in or through a specular object. ``active``:
    specular objects that may turn light on its way to the camera, because they are seen or cast a caustic that is.
    ``bands``: the bands of light that the scene asks for, if it has dispersive glass.
    """

    world: World
    direct: tuple[Object, ...]
    seen: tuple[Object, ...]
    paths: tuple[CausticPath, ...]
    lights: tuple[Light, ...]
    active: tuple[Object, ...]
    chain: Chain
    bands: tuple[Band, ...]

    @property
    def scene(self) -> Scene:
        return self.world.scene

    def material(self, item: Object) -> Material:
        return self.scene.material_of(item)

    @property
    def diffuse_seen(self) -> tuple[Object, ...]:
        return tuple(item for item in self.seen if self.material(item).is_diffuse)

    @property
    def active_glass(self) -> tuple[Object, ...]:
        return tuple(item for item in self.active if self.material(item).is_transmissive)

    def indices(self, item: Object) -> tuple[float, float]:
        """The lowest and the highest index of an object over the bands."""
        indices = ior_by_band(self.material(item), self.bands, self.scene.paper)
        return min(indices), max(indices)

    def levers(self, item: Object, by_camera: bool) -> list[Lever]:
        """Where a turn of light at an object shows: on the receivers of its caustics, and if it is seen, through it."""
        receivers = {path.receiver for path in self.paths if path.specular == item.name} - {item.name}
        found = [lever_on(self.world, item, other) for other in self.scene.objects if other.name in receivers]
        if by_camera and item in self.seen:
            found.append(lever_through(self.world.view))
        return found


def facts_of(world: World) -> Facts:
    """Look at a scene once, for all phenomena."""
    scene = world.scene
    direct, paths = directly_visible(world), caustic_paths(world)
    # Once light is on its way between specular objects it may meet any of them.
    takes_part = bool(paths) or any(scene.material_of(item).is_specular for item in direct)
    disperses = any(scene.material_of(item).is_dispersive for item in scene.objects)
    return Facts(
        world=world,
        direct=direct,
        seen=visible(world),
        paths=paths,
        lights=tuple(light for light in scene.lights if is_lit(light)),
        active=specular_objects(scene) if takes_part else (),
        chain=longest_chain(world),
        bands=band_model(scene.transport.bands).bands if disperses else (ALL_LIGHT,),
    )
