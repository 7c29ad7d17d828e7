#pragma once
/// The window that parallel light must pass to reach a target.

#include "light/sampling.h"
#include "light/target.h"

namespace vitrail {

/// center + a u + b v for a, b in [-1, 1], or with a^2 + b^2 <= 1 if round.
struct Window {
  Vec3 center, u, v;
  bool round = true;
  double area() const;
  Vec3 at(const UnitPoint& point) const {
    return round ? center + u * point.x + v * point.y : center + u * (2 * point.a - 1) + v * (2 * point.b - 1);
  }
};

/// The smaller of the disc around the target's sphere and the rectangle around its box, across `direction`.
Window window_on(const Target& target, Vec3 direction);

/// The point moved against `direction` to where nothing finite lies upstream of it.
Vec3 upstream_of(Vec3 point, Vec3 direction, const BoundingSphere& surroundings);

/// The point moved against `direction` to before every infinite plane that light from infinity crosses on its way to
/// it: such a plane stops, mirrors or bends that light, as it stops a shadow ray.
Vec3 before_planes(Vec3 point, Vec3 direction, const Surroundings& surroundings);

/// The planes that light along `direction` has crossed before it passes some place of the window.
std::vector<PlaneShape> planes_before(const Window& window, Vec3 direction, const std::vector<PlaneShape>& planes);

}  // namespace vitrail
