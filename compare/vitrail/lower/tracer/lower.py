"""Back end for our tracer: the scene as plain JSON, everything resolved, nothing left to look up.

The result is what ``vitrail-tracer`` reads; ``tracer/README.md`` documents every key. What the plan does not require is
taken out of the scene first (one band without dispersion, smooth faces without roughness, no depth beyond the longest
chain), so that the tracer cannot spend time on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from vitrail.geometry.camera import View
from vitrail.geometry.world import World
from vitrail.lower.tracer.lights import lowered_light
from vitrail.lower.tracer.materials import bands_of, lowered_material
from vitrail.lower.tracer.shapes import lowered_shape
from vitrail.plan.plan import Plan
from vitrail.plan.reduced import reduced
from vitrail.plan.settings import Settings
from vitrail.plan.views import ObservationView
from vitrail.scene.model import Ambient, Object, Scene
from vitrail.scene.print import scene_hash

Json = dict[str, Any]


def lower_tracer(
    world: World,
    plan: Plan,
    settings: Settings,
    *,
    views: Sequence[ObservationView] = (),
    wavelength_nm: float | None = None,
) -> Json:
    """The tracer's input, with all that it needs: the meshes and skies that the scene names are in it.

    All lengths are metres, all directions of unit length, colours linear Rec. 709; ``canonical_json`` prints it.
    Pictures of ``views`` are made from the photons of the scene's own picture.
    """
    scene, folder = world.scene, world.folder
    kept, bands = reduced(scene, plan), bands_of(scene, plan, wavelength_nm)
    used = [name for name in scene.materials if any(item.material == name for item in scene.objects)]
    lowered: Json = {
        "vitrail_lowered": 1,
        "title": scene.title,
        "scene_hash": scene_hash(scene),
        "image": {"width": scene.image.width, "height": scene.image.height},
        "camera": _camera(world.view),
        "bands": [asdict(band) for band in bands],
        "materials": [lowered_material(name, kept, bands) for name in used],
        "objects": [_object(world, item, used) for item in scene.objects],
        "lights": [lowered_light(light, folder) for light in scene.lights],
        "transport": _transport(kept),
        "paper": scene.paper.model_dump(mode="json"),
        "plan": plan.flags(),
        "settings": _settings(settings),
    }
    if views:
        lowered["views"] = [_view(view) for view in views]
    return lowered


def _view(view: ObservationView) -> Json:
    return {
        "name": view.name,
        "image": {"width": view.image.width, "height": view.image.height},
        "camera": _camera(View.of(view.camera, view.image)),
        "samples": view.samples,
    }


def _camera(view: View) -> Json:
    return {
        "kind": "perspective" if view.perspective else "orthographic",
        "position": view.position,
        "forward": view.forward,
        "right": view.right,
        "up": view.up,
        "half_width": view.half_width,
        "half_height": view.half_height,
    }


def _object(world: World, item: Object, used: list[str]) -> Json:
    return {
        "name": item.name,
        "material": used.index(item.material),
        "priority": item.priority or 0,
        "shape": lowered_shape(world.solid(item)),
    }


def _transport(kept: Scene) -> Json:
    """Depth limits are never beyond the longest specular chain of the plan."""
    indirect = kept.transport.indirect
    return {
        "indirect": {"ambient": indirect.ambient} if isinstance(indirect, Ambient) else indirect,
        "max_reflections": kept.transport.max_reflections,
        "max_transmissions": kept.transport.max_transmissions,
    }


def _settings(settings: Settings) -> Json:
    return {
        "samples": settings.samples,
        "photons": settings.photons,
        "gather_radius_m": settings.gather_radius_m,
        "seed": settings.seed,
        "rough_samples": settings.rough_samples,
        "final_gather_rays": settings.final_gather_rays,
        "memory_limit_mb": settings.memory_limit_mb,
        "solver": settings.solver,
        "branch_share": settings.branch_share,
        **({"gather_disc": True} if settings.gather_disc else {}),
    }
