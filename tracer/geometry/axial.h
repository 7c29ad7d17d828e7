#pragma once
/// Cylinder and cone: solids around an axis, closed by two end discs. Faces: 0 wall, 1 disc at `from`, 2 disc at `to`.

#include "geometry/bounds.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

/// A frustum whose radius goes linearly from one end to the other; equal radii make a cylinder.
class Axial {
 public:
  explicit Axial(const CylinderShape& shape) : Axial(shape.from, shape.to, shape.radius, shape.radius) {}
  explicit Axial(const ConeShape& shape) : Axial(shape.from, shape.to, shape.radius_from, shape.radius_to) {}

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  bool contains(Vec3 point) const;
  Bounds bounds() const;
  double coordinate_scale() const;

 private:
  Axial(Vec3 from, Vec3 to, double radius_from, double radius_to);

  Vec3 from_, axis_;
  double length_, radius_from_, radius_to_, slope_;  // slope = change of radius per length
};

/// Cut a span to the inside of a wall around the z axis whose radius is `radius` at the origin of the ray and changes
/// by `slope` per z. Lateral: the parts across the axis. `on_wall`: the ray starts on it. False if the line misses.
bool cut_wall(Span& span, Vec3 lateral_origin, Vec3 lateral_direction, double climb, double radius, double slope,
              std::uint32_t face, bool on_wall);

}  // namespace vitrail
