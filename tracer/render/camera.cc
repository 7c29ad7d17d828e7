#include "render/camera.h"

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
  __builtin_unreachable();
}

}  // namespace vitrail
