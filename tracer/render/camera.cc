#include "render/camera.h"

#include <stdexcept>

namespace vitrail {

Ray camera_ray(const Camera& camera, const Image& image, double x, double y) {
  const double sx = 2 * x / image.width - 1, sy = 1 - 2 * y / image.height;
  const Vec3 offset = camera.right * (sx * camera.half_width) + camera.up * (sy * camera.half_height);
  switch (camera.kind) {
    case CameraKind::perspective:
      return {camera.position, normalise(camera.forward + offset)};
    case CameraKind::orthographic:
      return {camera.position + offset, camera.forward};
  }
  throw std::logic_error("no such kind of camera");
}

std::optional<ImagePoint> project(const Camera& camera, const Image& image, Vec3 point) {
  const Vec3 way = point - camera.position;
  const double depth = dot(way, camera.forward);
  if (!(depth > 0)) return std::nullopt;

  // Offsets on the image plane: at distance 1 for a perspective, at any distance for an orthographic camera.
  const bool perspective = camera.kind == CameraKind::perspective;
  const double scale = perspective ? 1 / depth : 1;
  const double sx = dot(way, camera.right) * scale / camera.half_width;
  const double sy = dot(way, camera.up) * scale / camera.half_height;
  const double pixels_per_unit2 = image.width / (2 * camera.half_width) * (image.height / (2 * camera.half_height));

  // A patch that faces the ray at distance r covers 1/r^2 of solid angle, and that 1/cos^3 of it on the plane.
  const double distance = length(way), cosine = depth / distance;
  const double spread = perspective ? 1 / (distance * distance * cosine * cosine * cosine) : 1;
  return ImagePoint{(sx + 1) * 0.5 * image.width, (1 - sy) * 0.5 * image.height, pixels_per_unit2 * spread};
}

}  // namespace vitrail
