#pragma once
/// A box along the axes of its frame. Faces: 2 axis + (1 on the upper side).

#include "geometry/bounds.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

class Box {
 public:
  explicit Box(const BoxShape& shape);

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  bool contains(Vec3 point) const;
  Bounds bounds() const { return placed({min_, max_}, frame_); }
  double coordinate_scale() const;

 private:
  Vec3 min_, max_;  // in the frame
  Frame frame_;     // without rotation it stands at the origin and costs nothing
};

/// Cut a span to low <= origin + t direction <= high along one axis; the face that is left lies at t = 0.
/// False if the line runs outside and parallel.
bool cut_slab(Span& span, double origin, double direction, double low, double high, std::uint32_t face_low,
              std::uint32_t face_high, const Departure* left);

}  // namespace vitrail
