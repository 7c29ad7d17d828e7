#include "geometry/mesh.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostic.h"
#include "base/exact.h"
#include "geometry/mesh_closed.h"

namespace vitrail {

namespace {

/// The axes of a ray, its steepest last, and the shear that turns the ray into that axis: every corner is brought there
/// once and the same way for all triangles that share it, so that no ray slips between two of them.
struct Shear {
  int x, y, z;
  double sx, sy, sz;

  explicit Shear(Vec3 d) {
    const double ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
    z = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
    x = (z + 1) % 3;
    y = (x + 1) % 3;
    if (d[z] < 0) std::swap(x, y);
    sx = d[x] / d[z], sy = d[y] / d[z], sz = 1 / d[z];
  }
  Vec3 apply(Vec3 p) const { return {p[x] - sx * p[z], p[y] - sy * p[z], sz * p[z]}; }
};

/// How many triangles are asked at most, but for 16 faces of a huge mesh: some 50 ms.
constexpr std::uint32_t kOutsideTests = 1u << 21;

/// Leave out triangles without an area: no ray can hit them, and they have no normal.
void drop_degenerate(MeshData& mesh) {
  std::erase_if(mesh.triangles, [&](const std::array<std::uint32_t, 3>& corner) {
    const Vec3 a = mesh.vertices[corner[0]], b = mesh.vertices[corner[1]], c = mesh.vertices[corner[2]];
    return !(length_squared(cross(b - a, c - a)) > 0);
  });
}

/// ax by - ay bx with the right sign even where it cancels, and exactly the opposite for (b, a).
double turn(Vec3 a, Vec3 b) {
  const Exact first = exact_product(a.x, b.y), second = exact_product(a.y, b.x);
  return (first.value - second.value) + (first.error - second.error);
}

/// The side on which the ray passes an edge. A ray exactly through an edge is taken to pass a hair beside it, the same
/// hair for all triangles, so that it meets one of two neighbours and never both or none.
int side(double turn_of_edge, Vec3 a, Vec3 b) {
  if (turn_of_edge != 0) return turn_of_edge > 0 ? 1 : -1;
  if (a.y != b.y) return a.y > b.y ? 1 : -1;
  return a.x == b.x ? 0 : b.x > a.x ? 1 : -1;
}

}  // namespace

Mesh::Mesh(const MeshShape& shape) {
  MeshData data = *shape.data;
  open_fault_ = fault_of_closed_mesh(data);
  drop_degenerate(data);
  if (data.triangles.empty()) throw InputError({{"mesh", "has no triangle with an area", "write a mesh with faces"}});
  triangles_ = std::move(data.triangles);
  vertices_ = std::move(data.vertices);
  for (Vec3& vertex : vertices_) {
    vertex = shape.frame.point_to_world(vertex);
    bounds_.add(vertex);
    scale_ = std::max(scale_, largest_coordinate(vertex));
  }
  if (open_fault_.empty()) open_fault_ = fault_of_outside();
  if (!shape.smooth) return;

  // Take the normals of the file, or the mean of the neighbours weighted by their angle there.
  normals_.assign(vertices_.size(), Vec3{});
  if (!data.normals.empty()) {
    for (std::size_t i = 0; i < normals_.size(); ++i) normals_[i] = shape.frame.direction_to_world(data.normals[i]);
    return;
  }
  for (const auto& corners : triangles_)
    for (int i = 0; i < 3; ++i) {
      const Vec3 at = vertices_[corners[i]];
      const Vec3 next = vertices_[corners[(i + 1) % 3]] - at, last = vertices_[corners[(i + 2) % 3]] - at;
      const Vec3 area = cross(next, last);
      normals_[corners[i]] += normalise(area) * std::atan2(length(area), dot(next, last));
    }
}

bool Mesh::intersect_triangle(std::uint32_t triangle, const Ray& ray, const Departure* left, ShapeHit& hit) const {
  if (departs_from(left, triangle)) return false;
  const auto& [ia, ib, ic] = triangles_[triangle];
  const Shear shear(ray.direction);
  const Vec3 a = shear.apply(vertices_[ia] - ray.origin), b = shear.apply(vertices_[ib] - ray.origin),
             c = shear.apply(vertices_[ic] - ray.origin);

  // The ray meets the triangle if it passes all three edges on the same side.
  const double u = turn(b, c), v = turn(c, a), w = turn(a, b);
  const int first = side(u, b, c);
  if (first == 0 || side(v, c, a) != first || side(w, a, b) != first) return false;
  const double area = u + v + w;
  if (area == 0) return false;
  const double t = (u * a.z + v * b.z + w * c.z) / area;
  const bool entering = first < 0;

  // Within rounding of the start, believe what is known of the side and not the sign of t: a ray inside goes out, now
  // or later, and a ray outside does not come in again where it stands.
  if (left != nullptr && std::abs(t) <= position_error(ray.origin)) {
    if (!left->inside || entering) return false;
    hit = {t > 0 ? t : 0.0, triangle, false};
    return true;
  }
  if (!(t > 0)) return false;
  hit = {t, triangle, entering};
  return true;
}

bool Mesh::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  bool found = false;
  for (std::uint32_t triangle = 0; triangle < triangle_count(); ++triangle) {
    ShapeHit candidate;
    if (!intersect_triangle(triangle, ray, left, candidate) || (found && !(candidate.t < hit.t))) continue;
    hit = candidate;
    found = true;
  }
  return found;
}

bool Mesh::is_near_edge(Vec3 point, std::uint32_t face) const {
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = vertices_[triangles_[face][i]], b = vertices_[triangles_[face][(i + 1) % 3]];
    if (length(cross(b - a, point - a)) <= position_error(point) * length(b - a)) return true;
  }
  return false;
}

Bounds Mesh::triangle_bounds(std::uint32_t triangle) const {
  Bounds box;
  for (const std::uint32_t corner : triangles_[triangle]) box.add(vertices_[corner]);
  return box;
}

SurfacePoint Mesh::surface(Vec3 point, std::uint32_t face) const {
  const auto& [a, b, c] = triangles_[face];
  const Vec3 normal = normalise(cross(vertices_[b] - vertices_[a], vertices_[c] - vertices_[a]));
  return {point - normal * dot(point - vertices_[a], normal), normal};
}

Vec3 Mesh::shading_normal(Vec3 point, std::uint32_t face) const {
  const auto& [a, b, c] = triangles_[face];
  const Vec3 area = cross(vertices_[b] - vertices_[a], vertices_[c] - vertices_[a]);
  const Vec3 geometric = normalise(area);
  if (normals_.empty()) return geometric;

  // Weigh the three corners by the areas opposite to them.
  const double total = length_squared(area);
  const double u = dot(cross(vertices_[c] - vertices_[b], point - vertices_[b]), area) / total;
  const double v = dot(cross(vertices_[a] - vertices_[c], point - vertices_[c]), area) / total;
  const Vec3 smooth = normalise(normals_[a]) * u + normalise(normals_[b]) * v + normalise(normals_[c]) * (1 - u - v);
  const double size = length(smooth);
  return size > 0 && dot(smooth, geometric) > 0 ? smooth / size : geometric;
}

std::string Mesh::fault_of_outside() const {
  // Stand outside some faces, evenly over the file, and count what a ray away from them passes: where more goes in than
  // out, a wall has come out through its other side.
  const std::uint32_t asked = std::clamp(kOutsideTests / triangle_count(), 16u, triangle_count() + 16);
  const std::uint32_t step = std::max(1u, triangle_count() / asked);
  for (std::uint32_t face = 0; face < triangle_count(); face += step) {
    const auto& [a, b, c] = triangles_[face];
    const Vec3 middle = (vertices_[a] + vertices_[b] + vertices_[c]) / 3.0;
    const SurfacePoint at = surface(middle, face);
    const Departure left{0, face, false};
    int outward = 0;
    for (std::uint32_t triangle = 0; triangle < triangle_count(); ++triangle) {
      ShapeHit hit;
      if (intersect_triangle(triangle, {at.point, at.normal}, &left, hit)) outward += hit.entering ? -1 : 1;
    }
    if (outward < 0) return "crosses itself and is inside out in places";
  }
  return "";
}

bool Mesh::contains(Vec3 point) const {
  // Outside the box there is nothing to count.
  for (int axis = 0; axis < 3; ++axis)
    if (!(bounds_.min[axis] < point[axis] && point[axis] < bounds_.max[axis])) return false;

  // Count what a ray in a direction without any zero passes: going out adds, coming in takes away.
  const Ray probe{point, normalise({0.6180339887498949, 0.7548776662466927, 0.5698402909980532})};
  int outward = 0;
  for (std::uint32_t triangle = 0; triangle < triangle_count(); ++triangle) {
    ShapeHit hit;
    if (intersect_triangle(triangle, probe, nullptr, hit)) outward += hit.entering ? -1 : 1;
  }
  return outward > 0;
}

}  // namespace vitrail
