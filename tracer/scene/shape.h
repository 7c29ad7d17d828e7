#pragma once
/// The shapes of a lowered scene as data, in metres. Each says how it is read, where it is and how it is moved; what
/// rays ask of it stands in geometry/.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/frame.h"
#include "base/vec3.h"
#include "scene/mesh_data.h"

namespace vitrail {

class JsonValue;

/// Where a shape is and how large, roughly.
struct Place {
  Vec3 centre;
  double size = 0;
};

struct SphereShape {
  Vec3 center;
  double radius = 1;

  static SphereShape read(const JsonValue& value);
  std::optional<Place> place() const { return Place{center, radius}; }
  void move(Vec3 by) { center += by; }
};

/// Infinite; as a glass object the half-space below its normal.
struct PlaneShape {
  Vec3 point, normal;

  static PlaneShape read(const JsonValue& value);
  std::optional<Place> place() const { return {}; }
  void move(Vec3 by) { point += by; }
};

/// center + a u + b v for a, b in [-1, 1]; normal u x v.
struct RectangleShape {
  Vec3 center, u, v;

  static RectangleShape read(const JsonValue& value);
  std::optional<Place> place() const;
  void move(Vec3 by) { center += by; }
};

struct DiscShape {
  Vec3 center, normal;
  double radius = 1;

  static DiscShape read(const JsonValue& value);
  std::optional<Place> place() const { return Place{center, radius}; }
  void move(Vec3 by) { center += by; }
};

struct BoxShape {
  Vec3 min, max;
  Frame frame;

  static BoxShape read(const JsonValue& value);
  std::optional<Place> place() const;
  void move(Vec3 by) { frame.origin += by; }
};

/// Closed by its two end discs.
struct CylinderShape {
  Vec3 from, to;
  double radius = 1;

  static CylinderShape read(const JsonValue& value);
  std::optional<Place> place() const;
  void move(Vec3 by) { from += by, to += by; }
};

/// A closed frustum; one of the radii may be 0.
struct ConeShape {
  Vec3 from, to;
  double radius_from = 1, radius_to = 0;

  static ConeShape read(const JsonValue& value);
  std::optional<Place> place() const;
  void move(Vec3 by) { from += by, to += by; }
};

/// A polygon in x, y (counter-clockwise) extruded along z from -height/2 to height/2.
struct PrismShape {
  std::vector<std::array<double, 2>> corners;
  double height = 1;
  Frame frame;

  static PrismShape read(const JsonValue& value);
  std::optional<Place> place() const { return Place{frame.origin, height}; }
  void move(Vec3 by) { frame.origin += by; }
};

/// Two spherical faces about the z axis and a cylindrical rim, centred on the origin. The front faces -z, the back +z;
/// a positive radius is convex, a negative one concave, 0 is flat. `thickness` is at the axis.
struct LensShape {
  double radius_front = 0, radius_back = 0, thickness = 1, diameter = 1;
  Frame frame;

  static LensShape read(const JsonValue& value);
  std::optional<Place> place() const { return Place{frame.origin, diameter}; }
  void move(Vec3 by) { frame.origin += by; }
};

/// A ring torus: the points within radius_tube of a circle of `radius` about `center`, across `normal`.
struct TorusShape {
  Vec3 center, normal;
  double radius = 1, radius_tube = 0.25;

  static TorusShape read(const JsonValue& value);
  std::optional<Place> place() const { return Place{center, radius + radius_tube}; }
  void move(Vec3 by) { center += by; }
};

/// A polygon of [radius, height] turned about the y axis; straight pieces, closed from the last corner to the first.
struct LatheShape {
  std::vector<std::array<double, 2>> profile;
  Frame frame;

  static LatheShape read(const JsonValue& value);
  std::optional<Place> place() const;
  void move(Vec3 by) { frame.origin += by; }
};

/// Triangles; closed and outward where the material transmits.
struct MeshShape {
  std::shared_ptr<const MeshData> data;
  bool smooth = true;
  Frame frame;

  static MeshShape read(const JsonValue& value);
  std::optional<Place> place() const { return {}; }  // a mesh has no part in finding the centre
  void move(Vec3 by) { frame.origin += by; }
};

using Shape = std::variant<SphereShape, PlaneShape, RectangleShape, DiscShape, BoxShape, CylinderShape, ConeShape,
                           PrismShape, LensShape, TorusShape, LatheShape, MeshShape>;

/// A shape by its `kind`. A sphere stands in where the kind is at fault.
Shape read_shape(const JsonValue& value);

/// Whether every face lies in a plane.
inline bool has_flat_faces(const Shape& shape) {
  return std::holds_alternative<PlaneShape>(shape) || std::holds_alternative<RectangleShape>(shape) ||
         std::holds_alternative<DiscShape>(shape) || std::holds_alternative<BoxShape>(shape) ||
         std::holds_alternative<PrismShape>(shape);
}

}  // namespace vitrail
