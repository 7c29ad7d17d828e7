#pragma once
/// Equal-area maps from the unit square to discs, cones and the sphere. Continuous, so stratified points stay so.

#include <algorithm>
#include <array>
#include <cmath>

#include "base/frame.h"
#include "base/sine_cosine.h"

namespace vitrail {

/// A sample of two dimensions in both its shapes: in the unit square, and mapped from there onto the unit disc with
/// equal areas, squares to rings [Shirley and Chiu 1997].
struct UnitPoint {
  double a = 0.5, b = 0.5;
  double x = 0, y = 0;
};

/// Without branches, so that a loop over points becomes vector instructions.
inline UnitPoint unit_point(double a, double b) {
  const double x = 2 * a - 1, y = 2 * b - 1;
  const bool wide = std::abs(x) > std::abs(y);
  const double radius = wide ? x : y, other = wide ? y : x;
  const double ratio = radius != 0 ? other / radius : 0.0;
  const auto [sine, cosine] = sine_cosine((M_PI / 4) * ratio);
  const double along = radius * cosine, across = radius * sine;
  return {a, b, wide ? along : across, wide ? across : along};
}

/// Samples side by side, a column for each number, so that loops over them become vector instructions.
struct PointColumns {
  static constexpr std::size_t kCapacity = 256;
  std::array<double, kCapacity> a, b, x, y;

  /// Map all points (a, b) of the unit square onto the unit disc.
  void map(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const UnitPoint point = unit_point(a[i], b[i]);
      x[i] = point.x;
      y[i] = point.y;
    }
  }
  UnitPoint at(std::size_t i) const { return {a[i], b[i], x[i], y[i]}; }
};

/// A direction uniform in solid angle inside a cone about the axis of `frame`; `one_minus_cos` of its half angle, 2 for
/// the sphere.
inline Vec3 in_cone(Vec3 axis, const SurfaceFrame& frame, double one_minus_cos, const UnitPoint& point) {
  const double below = (point.x * point.x + point.y * point.y) * one_minus_cos;
  const double spread = std::sqrt(one_minus_cos * std::max(0.0, 2 - below));
  return normalise(axis * (1 - below) + frame.u * (point.x * spread) + frame.v * (point.y * spread));
}

/// A direction with the density of the cosine about a normal.
inline Vec3 cosine_direction(Vec3 normal, const UnitPoint& point) {
  const SurfaceFrame frame = surface_frame(normal);
  const double height = std::sqrt(std::max(0.0, 1 - (point.x * point.x + point.y * point.y)));
  return normalise(frame.u * point.x + frame.v * point.y + normal * height);
}

/// 1 - cos of the half angle under which a sphere is seen; 2 from inside it. Exact for small angles.
inline double one_minus_cos_of(double radius, double distance) {
  if (!(distance > radius)) return 2;
  const double sine = radius / distance;
  return sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
}

}  // namespace vitrail
