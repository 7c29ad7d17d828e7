#pragma once
/// The closed union of analytic shapes; adding one breaks the build until every question below has its answer.

#include <variant>

#include "geometry/axial.h"
#include "geometry/box.h"
#include "geometry/flat.h"
#include "geometry/lathe.h"
#include "geometry/lens.h"
#include "geometry/mesh.h"
#include "geometry/prism.h"
#include "geometry/sphere.h"
#include "geometry/torus.h"

namespace vitrail {

using Primitive = std::variant<Sphere, Plane, Rectangle, Disc, Box, Axial, Prism, Lens, Torus, Lathe, Mesh>;

/// The shape of an object, ready to be asked. Reads the file of a mesh.
Primitive make_primitive(const Shape& shape);

inline bool intersect(const Primitive& primitive, const Ray& ray, const Departure* left, ShapeHit& hit) {
  return std::visit([&](const auto& shape) { return shape.intersect(ray, left, hit); }, primitive);
}
inline SurfacePoint surface(const Primitive& primitive, Vec3 point, std::uint32_t face) {
  return std::visit([&](const auto& shape) { return shape.surface(point, face); }, primitive);
}
inline bool contains(const Primitive& primitive, Vec3 point) {
  return std::visit([&](const auto& shape) { return shape.contains(point); }, primitive);
}
inline Bounds bounds(const Primitive& primitive) {
  return std::visit([](const auto& shape) { return shape.bounds(); }, primitive);
}
inline double coordinate_scale(const Primitive& primitive) {
  return std::visit([](const auto& shape) { return shape.coordinate_scale(); }, primitive);
}

}  // namespace vitrail
