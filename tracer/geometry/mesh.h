#pragma once
/// A solid or sheet of triangles, as the lowered scene holds them. Faces: the triangles.

#include <array>
#include <string>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

class Mesh {
 public:
  /// Place the triangles; throws InputError if it cannot be used.
  explicit Mesh(const MeshShape& shape);

  /// Ask every triangle; for meshes of a few.
  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  bool intersect_triangle(std::uint32_t triangle, const Ray& ray, const Departure* left, ShapeHit& hit) const;
  /// Whether a point of a triangle cannot be told from its outline: a ray from there may slip past the next triangle.
  bool is_near_edge(Vec3 point, std::uint32_t face) const;
  Bounds triangle_bounds(std::uint32_t triangle) const;
  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangles_.size()); }

  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  /// The interpolated normal of a smooth mesh, on the same side as the geometric one.
  Vec3 shading_normal(Vec3 point, std::uint32_t face) const;
  bool contains(Vec3 point) const;
  /// Why the mesh does not enclose anything; empty if it does.
  const std::string& open_fault() const { return open_fault_; }
  Bounds bounds() const { return bounds_; }
  double coordinate_scale() const { return scale_; }

 private:
  std::string fault_of_outside() const;
  double position_error(Vec3 point) const { return 0x1p-48 * (largest_coordinate(point) + scale_); }

  std::vector<Vec3> vertices_, normals_;  // normals_ is empty for a flat mesh
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  Bounds bounds_;
  std::string open_fault_;
  double scale_ = 0;
};

}  // namespace vitrail
