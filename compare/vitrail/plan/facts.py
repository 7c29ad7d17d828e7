"""What the analysis knows about a scene before it decides anything: who is seen, who is lit, which paths there are."""

from __future__ import annotations

from dataclasses import dataclass

from vitrail.plan.chains import longest_chain
from vitrail.plan.light_paths import caustic_paths, directly_visible, visible
from vitrail.plan.light_reach import is_lit
from vitrail.plan.plan import CausticPath, Chain
from vitrail.scene.model import Light, Material, Object, Scene


@dataclass(frozen=True)
class Facts:
    """Who takes part in the picture.

    ``direct``: may be in the picture. ``seen``: may be seen, directly or in or through a specular object. ``active``:
    specular objects that may turn light on its way to the camera, because they are seen or cast a caustic that is.
    """

    scene: Scene
    direct: tuple[Object, ...]
    seen: tuple[Object, ...]
    paths: tuple[CausticPath, ...]
    lights: tuple[Light, ...]
    active: tuple[Object, ...]
    chain: Chain

    def material(self, item: Object) -> Material:
        return self.scene.material_of(item)

    @property
    def diffuse_seen(self) -> tuple[Object, ...]:
        return tuple(item for item in self.seen if self.material(item).is_diffuse)

    @property
    def active_glass(self) -> tuple[Object, ...]:
        return tuple(item for item in self.active if self.material(item).is_transmissive)


def facts_of(scene: Scene) -> Facts:
    """Look at a scene once, for all phenomena."""
    direct, seen, paths = directly_visible(scene), visible(scene), caustic_paths(scene)
    casters = {path.specular for path in paths}
    specular = [item for item in scene.objects if scene.material_of(item).is_specular]
    # Once light is on its way between specular objects it may meet any of them.
    touched = specular if casters or any(scene.material_of(item).is_specular for item in direct) else []
    return Facts(
        scene=scene,
        direct=direct,
        seen=seen,
        paths=paths,
        lights=tuple(light for light in scene.lights if is_lit(light)),
        active=tuple(touched),
        chain=longest_chain(scene),
    )
