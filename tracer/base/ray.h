#pragma once
/// A half line: where light comes from or where a look goes to.

#include "base/vec3.h"

namespace vitrail {

struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit length to rounding

  constexpr Vec3 at(double t) const { return origin + direction * t; }
};

}  // namespace vitrail
