#pragma once
/// From a place on the image to the ray that looks there.

#include "base/ray.h"
#include "scene/scene.h"

namespace vitrail {

/// The ray through (x, y) in pixels from the top left corner; pixel (i, j) is the square [i, i+1] x [j, j+1].
Ray camera_ray(const Camera& camera, const Image& image, double x, double y);

}  // namespace vitrail
