#pragma once
/// A ring torus: a tube around a circle. One face.

#include "geometry/bounds.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

/// The quartic is never expanded: the squared distance of a line from the ring, q(t) = (rho - R)^2 + z^2, is convex,
/// concave and convex again, with known ends of the concave part, so that every root lies alone in a known interval.
class Torus {
 public:
  explicit Torus(const TorusShape& shape)
      : center_(shape.center), axis_(shape.normal), ring_(shape.radius), tube_(shape.radius_tube) {}

  /// A hit is right to a few roundings of the ring's radius, divided by the sine of grazing incidence; a ray that
  /// stands on the surface has a root at exactly zero.
  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  bool contains(Vec3 point) const;
  Bounds bounds() const;
  double coordinate_scale() const;

 private:
  Vec3 center_, axis_;
  double ring_, tube_;  // radii: of the circle, of the tube around it
};

}  // namespace vitrail
