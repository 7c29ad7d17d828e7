#include "geometry/round.h"

#include <tuple>

namespace vitrail {

double power_of_point(Vec3 point, Vec3 center, double radius) {
  ExactSum sum;
  for (int axis = 0; axis < 3; ++axis) {
    // Square a difference with its rounding error: (v + e)^2 = v^2 + 2 v e to second order.
    const Exact difference = exact_sum(point[axis], -center[axis]);
    sum.add_product(difference.value, difference.value);
    sum.add(2 * difference.value * difference.error);
  }
  sum.add_product(-radius, radius);
  return sum.value();
}

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

Vec3 project_to_sphere(Vec3 point, Vec3 center, double radius) {
  // Step by the power of the point, twice: the first step squares the relative distance, the second is below rounding.
  for (int step = 0; step < 2; ++step) {
    const double excess = power_of_point(point, center, radius) / (2 * radius * radius);
    point = point - (point - center) * excess;
  }
  return point;
}

}  // namespace vitrail
