#include "geometry/primitive.h"

namespace vitrail {

namespace {

struct Make {
  Primitive operator()(const SphereShape& s) const { return Sphere(s); }
  Primitive operator()(const PlaneShape& s) const { return Plane(s); }
  Primitive operator()(const RectangleShape& s) const { return Rectangle(s); }
  Primitive operator()(const DiscShape& s) const { return Disc(s); }
  Primitive operator()(const BoxShape& s) const { return Box(s); }
  Primitive operator()(const CylinderShape& s) const { return Axial(s); }
  Primitive operator()(const ConeShape& s) const { return Axial(s); }
  Primitive operator()(const PrismShape& s) const { return Prism(s); }
  Primitive operator()(const LensShape& s) const { return Lens(s); }
  Primitive operator()(const TorusShape& s) const { return Torus(s); }
  Primitive operator()(const LatheShape& s) const { return Lathe(s); }
  Primitive operator()(const MeshShape& s) const { return Mesh(s); }
};

}  // namespace

Primitive make_primitive(const Shape& shape) { return std::visit(Make{}, shape); }

}  // namespace vitrail
