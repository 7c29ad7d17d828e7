#pragma once
/// The surfaces without thickness: plane, rectangle, disc. One face; a plane of glass is a half-space.

#include "geometry/bounds.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

/// What the three have in common: a point, a unit normal, and surface coordinates.
class Flat {
 public:
  Flat(Vec3 point, Vec3 normal, SurfaceFrame axes) : point_(point), normal_(normal), axes_(axes) {}

  /// The distance along a ray, or false if it is behind, parallel, or where the ray comes from.
  bool distance(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  double coordinate_scale() const { return largest_coordinate(point_); }

 protected:
  Vec3 point_, normal_;
  SurfaceFrame axes_;
};

class Plane : public Flat {
 public:
  explicit Plane(const PlaneShape& shape) : Flat(shape.point, shape.normal, surface_frame(shape.normal)) {}

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const { return distance(ray, left, hit); }
  bool contains(Vec3 point) const { return dot(point - point_, normal_) < 0; }
  Bounds bounds() const { return Bounds::everywhere(); }
};

class Rectangle : public Flat {
 public:
  explicit Rectangle(const RectangleShape& shape);

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  bool contains(Vec3) const { return false; }
  Bounds bounds() const;

 private:
  double half_u_, half_v_;
};

class Disc : public Flat {
 public:
  explicit Disc(const DiscShape& shape)
      : Flat(shape.center, shape.normal, surface_frame(shape.normal)), radius_(shape.radius) {}

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  bool contains(Vec3) const { return false; }
  Bounds bounds() const;

 private:
  double radius_;
};

}  // namespace vitrail
