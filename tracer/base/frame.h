#pragma once
/// Rigid placement of a shape, and the surface coordinates of flat shapes.

#include <cmath>

#include "base/vec3.h"

namespace vitrail {

/// world = rotation * local + origin; `row` are the rows of the rotation. An identity rotation costs no rounding.
struct Frame {
  Vec3 origin;
  Vec3 row[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  bool identity = true;  // the rotation is exactly 1; the origin may still be anywhere

  Vec3 direction_to_world(Vec3 d) const { return identity ? d : Vec3{dot(row[0], d), dot(row[1], d), dot(row[2], d)}; }
  Vec3 direction_to_local(Vec3 d) const { return identity ? d : row[0] * d.x + row[1] * d.y + row[2] * d.z; }
  Vec3 point_to_world(Vec3 p) const { return direction_to_world(p) + origin; }
  Vec3 point_to_local(Vec3 p) const { return direction_to_local(p - origin); }
};

/// Two directions that make a right-handed frame with a unit normal.
struct SurfaceFrame {
  Vec3 u, v;
};

/// Surface coordinates of a plane or disc, the same rule as the scene language: u = normalise(a - (a.n) n) with a = +x,
/// or +z where |n.x| > 0.9; v = n x u.
inline SurfaceFrame surface_frame(Vec3 normal) {
  const Vec3 a = std::abs(normal.x) > 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = normalise(a - normal * dot(a, normal));
  return {u, cross(normal, u)};
}

}  // namespace vitrail
