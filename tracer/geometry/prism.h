#pragma once
/// A polygon, convex or not, extruded along z of its frame. Faces: side i from corner i to corner i + 1, then the lower
/// end (number of corners) and the upper end.

#include <vector>

#include "geometry/bounds.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

class Prism {
 public:
  explicit Prism(const PrismShape& shape);

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  bool contains(Vec3 point) const;
  Bounds bounds() const;
  double coordinate_scale() const;

 private:
  struct Corner {
    double x, y;
  };
  struct Cut {
    double t;
    std::uint32_t face;
  };

  bool polygon_contains(double x, double y) const;
  /// Where the line crosses the outline, in order; always an even number.
  void outline_cuts(const Ray& local, const Departure* left, std::vector<Cut>& cuts) const;

  std::vector<Corner> corners_;
  double half_height_;
  Frame frame_;
};

}  // namespace vitrail
