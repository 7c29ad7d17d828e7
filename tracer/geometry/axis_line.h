#pragma once
/// A line as an axis sees it: its height along the axis and its distance from it, with all digits kept near the axis.

#include <cmath>

#include "base/vec3.h"

namespace vitrail {

/// At t the line is at height + t climb, and across + t pace beside the point where it passes the axis at `miss`.
/// pace >= 0; a line parallel to the axis has pace 0 and all of its distance in `miss`.
struct AxisLine {
  double height = 0, climb = 0, across = 0, pace = 0, miss = 0;

  /// `offset` is the origin of the line seen from a point of the axis; `axis` has unit length.
  AxisLine(Vec3 offset, Vec3 direction, Vec3 axis) : height(dot(offset, axis)), climb(dot(direction, axis)) {
    const Vec3 lateral = offset - axis * height, drift = direction - axis * climb;
    pace = length(drift);
    if (!(pace > 0)) {
      miss = length(lateral);
      return;
    }
    const Vec3 onward = drift / pace;
    across = dot(lateral, onward);
    miss = length(lateral - onward * across);
  }

  double height_at(double t) const { return height + climb * t; }
  double across_at(double t) const { return across + pace * t; }
  /// The distance from the axis.
  double radius_at(double t) const { return std::sqrt(across_at(t) * across_at(t) + miss * miss); }
};

}  // namespace vitrail
