"""Where the bodies of a scene are: shapes, placement, bounds, overlap, contact, meshes and the camera."""
