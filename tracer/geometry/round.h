#pragma once
/// Lines against balls and round walls: roots that keep their digits near, far, and from a start on the surface.

#include <utility>

#include "base/exact.h"
#include "base/ray.h"
#include "geometry/span.h"

namespace vitrail {

/// |p - c|^2 - r^2, the signed power of a point, right to about the last digit even where p is a micron above a planet.
double power_of_point(Vec3 point, Vec3 center, double radius);

/// The roots of a t^2 - 2 b t + c = 0 in order, given a > 0 and h = sqrt(b^2 - a c): no difference of like numbers.
inline std::pair<double, double> stable_roots(double a, double b, double c, double h) {
  const double q = b >= 0 ? b + h : b - h;
  if (q == 0) return {0, 0};
  const double first = c / q, second = q / a;
  return first < second ? std::pair{first, second} : std::pair{second, first};
}

/// Where a line is inside a ball. `on_surface`: the ray starts on it, so one root is zero and the other 2 b [O 2.14].
/// False if the line misses.
bool ball_span(Vec3 center, double radius, const Ray& ray, bool on_surface, double& in, double& out);

/// The nearest point of a sphere to a point close to it.
Vec3 project_to_sphere(Vec3 point, Vec3 center, double radius);

}  // namespace vitrail
