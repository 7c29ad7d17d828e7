#pragma once
/// Two spherical or flat faces about the z axis of the frame, and a cylindrical rim. Faces: 0 front (at -z), 1 back, 2
/// rim.

#include "geometry/bounds.h"
#include "geometry/span.h"
#include "scene/scene.h"

namespace vitrail {

class Lens {
 public:
  explicit Lens(const LensShape& shape);

  bool intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const;
  SurfacePoint surface(Vec3 point, std::uint32_t face) const;
  bool contains(Vec3 point) const;
  Bounds bounds() const;
  double coordinate_scale() const;

 private:
  /// One of the two faces. All z are in the frame; `out` is -1 for the front and +1 for the back.
  struct Cap {
    double radius = 0;  // > 0 convex, < 0 concave, 0 flat
    double vertex = 0;  // z on the axis
    double center = 0;  // z of the centre of curvature
    double rim = 0;     // z at the rim
    double out = 1;
  };
  static Cap make_cap(double radius, double half_thickness, double half_diameter, double out);

  bool cut_convex(Span& span, const Ray& local, const Cap& cap, std::uint32_t face, const Departure* left) const;
  static bool within(const Cap& cap, Vec3 local);

  Cap caps_[2];
  double half_diameter_;
  Frame frame_;
};

}  // namespace vitrail
