#pragma once
/// Equal-area maps from the unit square to discs, cones and the sphere. Continuous, so that stratified points stay so.

#include <algorithm>
#include <array>
#include <cmath>

#include "base/frame.h"

namespace vitrail {

/// The unit square onto the unit disc, squares to rings [Shirley and Chiu 1997].
inline std::array<double, 2> on_unit_disc(double a, double b) {
  const double x = 2 * a - 1, y = 2 * b - 1;
  if (x == 0 && y == 0) return {0, 0};
  if (std::abs(x) > std::abs(y)) {
    const double angle = (M_PI / 4) * (y / x);
    return {x * std::cos(angle), x * std::sin(angle)};
  }
  const double angle = (M_PI / 4) * (x / y);
  return {y * std::sin(angle), y * std::cos(angle)};
}

/// A direction uniform in solid angle inside a cone about `axis`; `one_minus_cos` of its half angle, 2 for the sphere.
inline Vec3 in_cone(Vec3 axis, double one_minus_cos, double a, double b) {
  const auto [x, y] = on_unit_disc(a, b);
  const double below = (x * x + y * y) * one_minus_cos;
  const double spread = std::sqrt(one_minus_cos * std::max(0.0, 2 - below));
  const SurfaceFrame frame = surface_frame(axis);
  return normalise(axis * (1 - below) + frame.u * (x * spread) + frame.v * (y * spread));
}

/// 1 - cos of the half angle under which a sphere is seen; 2 from inside it. Exact for small angles.
inline double one_minus_cos_of(double radius, double distance) {
  if (!(distance > radius)) return 2;
  const double sine = radius / distance;
  return sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
}

}  // namespace vitrail
