#pragma once
/// From a place on the image to the ray that looks there.

#include <optional>

#include "base/ray.h"
#include "scene/scene.h"

namespace vitrail {

/// The ray through (x, y) in pixels from the top left corner; pixel (i, j) is the square [i, i+1] x [j, j+1].
Ray camera_ray(const Camera& camera, const Image& image, double x, double y);

/// Where the camera sees a point.
struct ImagePoint {
  double x = 0, y = 0;              // pixels, as for camera_ray
  double pixels_per_facing_m2 = 0;  // how many pixels a square metre covers that faces the camera there
};

/// The inverse of camera_ray; nothing for points behind the camera. Whether anything is in between is not asked.
std::optional<ImagePoint> project(const Camera& camera, const Image& image, Vec3 point);

}  // namespace vitrail
