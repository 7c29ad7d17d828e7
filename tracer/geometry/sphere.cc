#include "geometry/sphere.h"

namespace vitrail {

SurfacePoint Sphere::surface(Vec3 point, std::uint32_t) const {
  const Vec3 on_sphere = project_to_sphere(point, center_, radius_);
  return {on_sphere, normalise(on_sphere - center_)};
}

bool Sphere::contains(Vec3 point) const { return power_of_point(point, center_, radius_) < 0; }

Bounds Sphere::bounds() const {
  const Vec3 reach{radius_, radius_, radius_};
  return {center_ - reach, center_ + reach};
}

}  // namespace vitrail
