#pragma once
/// A half line: where light comes from or where a look goes to.

#include <limits>

#include "base/vec3.h"

namespace vitrail {

/// The distance of what is never met.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit length to rounding

  constexpr Vec3 at(double t) const { return origin + direction * t; }
};

}  // namespace vitrail
