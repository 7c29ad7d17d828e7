#pragma once
/// A ball: one face.

#include "geometry/bounds.h"
#include "geometry/round.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

class Sphere {
 public:
  explicit Sphere(const SphereShape& shape) : center_(shape.center), radius_(shape.radius) {}

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
    // A ray that goes away from the ball it stands on never comes back.
    if (left != nullptr && !left->inside) return false;
    Span span;
    return ball_span(center_, radius_, ray, left != nullptr, span.in, span.out) && first_event(span, left, hit);
  }
  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  bool contains(Vec3 point) const;
  Bounds bounds() const;
  /// The coordinates whose rounding a hit carries: none, the roots are exact near the surface.
  double coordinate_scale() const { return 0; }

 private:
  Vec3 center_;
  double radius_;
};

}  // namespace vitrail
