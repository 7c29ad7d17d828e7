#pragma once
/// Boxes along the axes.

#include <algorithm>

#include "base/frame.h"
#include "base/ray.h"

namespace vitrail {

struct Bounds {
  Vec3 min{kInfinity, kInfinity, kInfinity}, max{-kInfinity, -kInfinity, -kInfinity};

  static Bounds everywhere() { return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}}; }

  bool is_empty() const { return !(min.x <= max.x); }
  bool is_finite() const { return vitrail::is_finite(min) && vitrail::is_finite(max); }
  void add(Vec3 point) {
    min = {std::min(min.x, point.x), std::min(min.y, point.y), std::min(min.z, point.z)};
    max = {std::max(max.x, point.x), std::max(max.y, point.y), std::max(max.z, point.z)};
  }
  void add(const Bounds& other) {
    if (!other.is_empty()) add(other.min), add(other.max);
  }
};

/// The box around a placed box.
inline Bounds placed(const Bounds& local, const Frame& frame) {
  Bounds world;
  for (int corner = 0; corner < 8; ++corner)
    world.add(frame.point_to_world({corner & 1 ? local.max.x : local.min.x, corner & 2 ? local.max.y : local.min.y,
                                    corner & 4 ? local.max.z : local.min.z}));
  return world;
}

}  // namespace vitrail
