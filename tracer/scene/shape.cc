#include "scene/shape.h"

#include <algorithm>
#include <cmath>

#include "scene/json_value.h"

namespace vitrail {

namespace {

/// Rows of a rotation: orthonormal and right-handed within the digits that a decimal print keeps.
Frame read_frame(const JsonValue& value) {
  Frame frame;
  if (!value.object({"origin", "rotation"}, {"identity"})) return frame;
  frame.origin = value.at("origin").vector();
  const JsonValue rotation = value.at("rotation");
  const std::vector<JsonValue> rows = rotation.array(3);
  if (rows.empty()) return frame;
  for (int i = 0; i < 3; ++i) frame.row[i] = rows[i].vector();

  const double slack = 1e-9;
  const Vec3 third = cross(frame.row[0], frame.row[1]);
  if (!(length(third - frame.row[2]) <= slack) || !(std::abs(length(frame.row[0]) - 1) <= slack) ||
      !(std::abs(length(frame.row[1]) - 1) <= slack) || !(std::abs(dot(frame.row[0], frame.row[1])) <= slack))
    rotation.fault("is not a rotation", "write three rows of unit length, perpendicular, the third the cross product");
  frame.identity = frame.row[0] == Vec3{1, 0, 0} && frame.row[1] == Vec3{0, 1, 0} && frame.row[2] == Vec3{0, 0, 1};
  return frame;
}

void refuse_same_ends(const JsonValue& value, Vec3 from, Vec3 to) {
  if (value.has("from") && value.has("to") && !(length_squared(to - from) > 0))
    value.fault("has the same point for `from` and `to`", "move one of them");
}

Place place_between(Vec3 a, Vec3 b, double margin) {
  return {(a + b) * 0.5, std::max(largest_coordinate(b - a), margin)};
}

double doubled_area(const std::vector<std::array<double, 2>>& corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    area += a[0] * b[1] - b[0] * a[1];
  }
  return area;
}

/// What is wrong with the outline of a turned solid; it may run either way round. Crossings are left to `vitrail
/// check`.
std::string fault_of_outline(const std::vector<std::array<double, 2>>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i] == corners[(i + 1) % corners.size()]) return "has the same corner twice in a row";
  return corners.size() < 3 || doubled_area(corners) == 0 ? "is no polygon with an area" : "";
}

std::vector<Vec3> read_triplets(const JsonValue& value) {
  const std::vector<double> numbers = value.packed<double>();
  std::vector<Vec3> triplets;
  triplets.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    triplets.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  if (numbers.size() % 3 != 0) value.fault("holds " + std::to_string(numbers.size()) + " numbers", "pack three each");
  for (const Vec3& each : triplets)
    if (!is_finite(each)) return value.fault("holds what is not finite", "pack finite numbers"), std::vector<Vec3>{};
  return triplets;
}

std::vector<std::array<std::uint32_t, 3>> read_triangles(const JsonValue& value, std::size_t vertices) {
  const std::vector<std::uint32_t> corners = value.packed<std::uint32_t>();
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (corners.size() % 3 != 0) value.fault("holds " + std::to_string(corners.size()) + " corners", "pack three each");
  for (const std::uint32_t corner : corners)
    if (corner >= vertices) return value.fault("names a vertex that is not there", "count from 0"), triangles;
  triangles.reserve(corners.size() / 3);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return triangles;
}

template <typename Part>
Shape read_as(const JsonValue& value) {
  return Part::read(value);
}

using Reader = Shape (*)(const JsonValue&);

constexpr Choice<Reader> kReaders[] = {
    {"sphere", read_as<SphereShape>}, {"plane", read_as<PlaneShape>}, {"rectangle", read_as<RectangleShape>},
    {"disc", read_as<DiscShape>},     {"box", read_as<BoxShape>},     {"cylinder", read_as<CylinderShape>},
    {"cone", read_as<ConeShape>},     {"prism", read_as<PrismShape>}, {"lens", read_as<LensShape>},
    {"torus", read_as<TorusShape>},   {"lathe", read_as<LatheShape>}, {"mesh", read_as<MeshShape>},
};
static_assert(std::size(kReaders) == std::variant_size_v<Shape>, "every shape has a name in the scene file");

}  // namespace

SphereShape SphereShape::read(const JsonValue& value) {
  value.object({"kind", "center", "radius"});
  return {value.at("center").vector(), value.at("radius").number(Range::positive())};
}

PlaneShape PlaneShape::read(const JsonValue& value) {
  value.object({"kind", "point", "normal"});
  return {value.at("point").vector(), value.at("normal").unit_vector()};
}

RectangleShape RectangleShape::read(const JsonValue& value) {
  value.object({"kind", "center", "u", "v"});
  const RectangleShape shape{value.at("center").vector(), value.at("u").vector(), value.at("v").vector()};
  const double size = length(shape.u) * length(shape.v);
  if (value.has("u") && value.has("v") && !(size > 0 && std::abs(dot(shape.u, shape.v)) <= 1e-9 * size))
    value.fault("has half edges that are zero or not perpendicular", "write two perpendicular vectors u and v");
  return shape;
}

std::optional<Place> RectangleShape::place() const {
  return Place{center, std::max(largest_coordinate(u), largest_coordinate(v))};
}

DiscShape DiscShape::read(const JsonValue& value) {
  value.object({"kind", "center", "normal", "radius"});
  return {value.at("center").vector(), value.at("normal").unit_vector(), value.at("radius").number(Range::positive())};
}

BoxShape BoxShape::read(const JsonValue& value) {
  value.object({"kind", "min", "max", "frame"});
  BoxShape box{value.at("min").vector(), value.at("max").vector(), read_frame(value.at("frame"))};
  if (value.has("min") && value.has("max") &&
      !(box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z))
    value.fault("has no volume", "every coordinate of min must be below that of max");
  return box;
}

std::optional<Place> BoxShape::place() const {
  return Place{frame.point_to_world((min + max) * 0.5), largest_coordinate(max - min)};
}

CylinderShape CylinderShape::read(const JsonValue& value) {
  value.object({"kind", "from", "to", "radius"});
  CylinderShape shape{value.at("from").vector(), value.at("to").vector(), value.at("radius").number(Range::positive())};
  refuse_same_ends(value, shape.from, shape.to);
  return shape;
}

std::optional<Place> CylinderShape::place() const { return place_between(from, to, radius); }

ConeShape ConeShape::read(const JsonValue& value) {
  value.object({"kind", "from", "to", "radius_from", "radius_to"});
  ConeShape shape{value.at("from").vector(), value.at("to").vector(),
                  value.at("radius_from").number(Range::not_negative()),
                  value.at("radius_to").number(Range::not_negative())};
  refuse_same_ends(value, shape.from, shape.to);
  if (shape.radius_from == shape.radius_to) value.fault("has equal radii", "write a cylinder instead");
  return shape;
}

std::optional<Place> ConeShape::place() const { return place_between(from, to, std::max(radius_from, radius_to)); }

PrismShape PrismShape::read(const JsonValue& value) {
  value.object({"kind", "corners", "height", "frame"});
  PrismShape shape;
  const JsonValue corners = value.at("corners");
  for (const JsonValue& corner : corners.array()) {
    const std::vector<JsonValue> xy = corner.array(2);
    if (!xy.empty()) shape.corners.push_back({xy[0].number(), xy[1].number()});
  }
  shape.height = value.at("height").number(Range::positive());
  shape.frame = read_frame(value.at("frame"));

  // Ask for a polygon that has an inside on its left.
  for (std::size_t i = 0; i < shape.corners.size(); ++i)
    if (shape.corners[i] == shape.corners[(i + 1) % shape.corners.size()])
      corners.fault("has the same corner twice in a row", "drop one of them");
  if (shape.corners.size() < 3 || !(doubled_area(shape.corners) > 0))
    corners.fault("is no polygon with a positive area", "list at least three corners counter-clockwise");
  return shape;
}

LensShape LensShape::read(const JsonValue& value) {
  value.object({"kind", "radius_front", "radius_back", "thickness", "diameter", "frame"});
  LensShape lens{value.at("radius_front").number(), value.at("radius_back").number(),
                 value.at("thickness").number(Range::positive()), value.at("diameter").number(Range::positive()),
                 read_frame(value.at("frame"))};

  // The faces may curve at most to a hemisphere, and must leave some rim between them.
  double rim = lens.thickness;
  for (const double radius : {lens.radius_front, lens.radius_back}) {
    const double half = lens.diameter / 2;
    if (radius == 0) continue;
    if (!(std::abs(radius) >= half)) {
      value.fault("has a face whose radius is below half the diameter", "enlarge the radius or reduce the diameter");
      return lens;
    }
    const double sag =
        half * half / (std::abs(radius) + std::sqrt((std::abs(radius) - half) * (std::abs(radius) + half)));
    rim -= radius > 0 ? sag : -sag;
  }
  if (!(rim >= 0)) value.fault("has faces that cross inside the rim", "enlarge the thickness or reduce the diameter");
  return lens;
}

TorusShape TorusShape::read(const JsonValue& value) {
  value.object({"kind", "center", "normal", "radius", "radius_tube"});
  const TorusShape shape{value.at("center").vector(), value.at("normal").unit_vector(),
                         value.at("radius").number(Range::positive()),
                         value.at("radius_tube").number(Range::positive())};
  if (value.has("radius") && value.has("radius_tube") && !(shape.radius_tube < shape.radius))
    value.fault("has a tube that fills its ring", "write a radius_tube below the radius");
  return shape;
}

LatheShape LatheShape::read(const JsonValue& value) {
  value.object({"kind", "profile", "frame"});
  LatheShape shape;
  const JsonValue profile = value.at("profile");
  for (const JsonValue& corner : profile.array()) {
    const std::vector<JsonValue> place = corner.array(2);
    if (!place.empty()) shape.profile.push_back({place[0].number(Range::not_negative()), place[1].number()});
  }
  shape.frame = read_frame(value.at("frame"));
  if (const std::string fault = fault_of_outline(shape.profile); !fault.empty())
    profile.fault(fault, "list at least three corners around an area, in order");
  return shape;
}

std::optional<Place> LatheShape::place() const {
  Vec3 low{0, profile[0][1], 0}, high = low;
  for (const auto& [radius, height] : profile) {
    high.x = std::max(high.x, radius);
    low.y = std::min(low.y, height);
    high.y = std::max(high.y, height);
  }
  return Place{frame.point_to_world({0, (low.y + high.y) / 2, 0}), std::max(high.x, high.y - low.y)};
}

MeshShape MeshShape::read(const JsonValue& value) {
  value.object({"kind", "vertices", "triangles", "smooth", "frame"}, {"normals"});
  MeshData data;
  data.vertices = read_triplets(value.at("vertices"));
  if (value.has("normals")) data.normals = read_triplets(value.at("normals"));
  if (!data.normals.empty() && data.normals.size() != data.vertices.size())
    value.at("normals").fault("has not one normal a vertex", "write as many as vertices, or leave it out");
  data.triangles = read_triangles(value.at("triangles"), data.vertices.size());
  return {std::make_shared<const MeshData>(std::move(data)), value.at("smooth").boolean(),
          read_frame(value.at("frame"))};
}

Shape read_shape(const JsonValue& value) {
  if (!value.is_object() || !value.has("kind")) {
    value.fault("has no `kind`", "write an object with its kind and dimensions");
    return SphereShape{};
  }
  return value.at("kind").choice(kReaders)(value);
}

}  // namespace vitrail
