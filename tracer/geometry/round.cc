#include "geometry/round.h"

#include <tuple>

namespace vitrail {

bool ball_span(Vec3 center, double radius, const Ray& ray, bool on_surface, double& in, double& out) {
  const Vec3 to_center = center - ray.origin;
  const double b = dot(to_center, ray.direction);
  if (on_surface) {
    in = b < 0 ? 2 * b : 0;
    out = b < 0 ? 0 : 2 * b;
    return true;
  }

  // Decide from the closest approach of the line, whose distance to the centre keeps its digits from afar [O 2.11].
  const double distance = length(to_center - ray.direction * b);
  if (!(distance < radius)) return false;
  const double h = std::sqrt((radius - distance) * (radius + distance));
  std::tie(in, out) = stable_roots(1, b, power_of_point(ray.origin, center, radius), h);
  return true;
}

}  // namespace vitrail
