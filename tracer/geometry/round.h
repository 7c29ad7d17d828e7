#pragma once
/// Lines against balls and round walls: roots that keep their digits near, far, and from a start on the surface.

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/exact.h"
#include "base/ray.h"
#include "geometry/span.h"

namespace vitrail {

/// |p - c|^2 - r^2, the signed power of a point, right to about the last digit even where p is a micron above a planet.
inline double power_of_point(Vec3 point, Vec3 center, double radius) {
  // Square each difference with its rounding error: (v + e)^2 = v^2 + 2 v e to second order.
  const Exact x = exact_sum(point.x, -center.x), y = exact_sum(point.y, -center.y), z = exact_sum(point.z, -center.z);
  const Exact xx = exact_product(x.value, x.value), yy = exact_product(y.value, y.value),
              zz = exact_product(z.value, z.value), rr = exact_product(radius, radius);
  const double small =
      2 * (x.value * x.error + y.value * y.error + z.value * z.error) + (xx.error + yy.error + zz.error - rr.error);
  const Exact first = exact_sum(xx.value, yy.value), second = exact_sum(zz.value, -rr.value);
  const Exact sum = exact_sum(first.value, second.value);
  return sum.value + (sum.error + first.error + second.error + small);
}

/// The roots of a t^2 - 2 b t + c = 0 in order, given a > 0 and h = sqrt(b^2 - a c): no difference of like numbers.
inline std::pair<double, double> stable_roots(double a, double b, double c, double h) {
  const double q = b >= 0 ? b + h : b - h;
  if (q == 0) return {0, 0};
  const double first = c / q, second = q / a;
  return first < second ? std::pair{first, second} : std::pair{second, first};
}

/// Where a line is inside a ball. `on_surface`: the ray starts on it, so one root is zero and the other 2 b [O 2.14].
/// False if the line misses.
inline bool ball_span(Vec3 center, double radius, const Ray& ray, bool on_surface, double& in, double& out) {
  const Vec3 to_center = center - ray.origin;
  const double b = dot(to_center, ray.direction);
  if (on_surface) {
    in = b < 0 ? 2 * b : 0;
    out = b < 0 ? 0 : 2 * b;
    return true;
  }

  // Decide from the closest approach of the line, whose distance to the centre keeps its digits from afar [O 2.11].
  const double closest_squared = length_squared(to_center - ray.direction * b);
  if (!(closest_squared < radius * radius)) return false;
  const double closest = std::sqrt(closest_squared);
  const double h = std::sqrt(std::max(0.0, (radius - closest) * (radius + closest)));
  std::tie(in, out) = stable_roots(1, b, power_of_point(ray.origin, center, radius), h);
  return true;
}

/// The nearest point of a sphere to a point close to it.
inline Vec3 project_to_sphere(Vec3 point, Vec3 center, double radius) {
  // Step by the power of the point. A step squares the relative distance: below 2^-27 one is enough.
  for (int step = 0; step < 3; ++step) {
    const double excess = power_of_point(point, center, radius) / (2 * radius * radius);
    point = point - (point - center) * excess;
    if (std::abs(excess) < 0x1p-27) break;
  }
  return point;
}

}  // namespace vitrail
