#pragma once
/// A scene together with its surfaces, ready to be asked by rays: what every path through it needs.

#include "geometry/accel.h"

namespace vitrail {

/// Both must outlive the world, which is made once and handed on.
struct World {
  const Scene& scene;
  const Intersector& intersector;
};

}  // namespace vitrail
