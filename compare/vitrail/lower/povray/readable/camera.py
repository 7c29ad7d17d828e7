"""The camera as an author of POV-Ray would write it: place, aim, angle, and any size of picture."""

from __future__ import annotations

from vitrail.lower.povray.bodies.normalise import Normalisation
from vitrail.lower.povray.text.sdl import Block, Call, Comment, Product, Quotient, Value, block, statement, vector
from vitrail.scene.model import Camera


def readable_camera(camera: Camera, units: Normalisation) -> Block:
    """Right-handed, as the scene is: ``right`` points to -x. The picture's height stays when its shape changes."""
    half_turns = Quotient(Call("radians", (camera.fov_deg or 0.0,)), 2)
    height = units.length(camera.height or 0.0)
    is_perspective = camera.kind == "perspective"
    right: tuple[Value, ...] = (Product(-1, Product("x", Quotient("image_width", "image_height"))),)
    up: tuple[Value, ...] = ("y",)
    if not is_perspective:
        right, up = (Product(height, right[0]),), (Product(height, "y"),)
    return block(
        "camera",
        statement(camera.kind),
        statement("location", vector(units.point(camera.position))),
        Comment("right-handed, as the scene is: x points to the right of a viewer who looks along -z"),
        statement("right", *right),
        statement("up", *up),
        Comment(f"{camera.fov_deg:g} degrees from the top to the bottom of the picture") if is_perspective else None,
        statement("direction", Product("z", Quotient(0.5, Call("tan", (half_turns,))))) if is_perspective else None,
        statement("sky", vector(camera.up)),
        statement("look_at", vector(units.point(camera.look_at))),
    )
