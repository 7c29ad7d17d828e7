#include "geometry/mesh.h"

#include <cmath>

#include "base/exact.h"
#include "geometry/mesh_file.h"

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

/// ax by - ay bx with the right sign even where it cancels.
double turn(double ax, double ay, double bx, double by) {
  const Exact first = exact_product(ax, by), second = exact_product(ay, bx);
  return (first.value - second.value) + (first.error - second.error);
}

}  // namespace

Mesh::Mesh(const MeshShape& shape) {
  MeshData data = read_mesh_file(shape.file);
  triangles_ = std::move(data.triangles);
  vertices_ = std::move(data.vertices);
  for (Vec3& vertex : vertices_) {
    vertex = shape.frame.point_to_world(vertex);
    bounds_.add(vertex);
    scale_ = std::max(scale_, largest_coordinate(vertex));
  }
  if (!shape.smooth) return;

  // Take the normals of the file, or the mean of the neighbours weighted by their area.
  normals_.assign(vertices_.size(), Vec3{});
  if (!data.normals.empty()) {
    for (std::size_t i = 0; i < normals_.size(); ++i) normals_[i] = shape.frame.direction_to_world(data.normals[i]);
    return;
  }
  for (const auto& [a, b, c] : triangles_) {
    const Vec3 area = cross(vertices_[b] - vertices_[a], vertices_[c] - vertices_[a]);
    for (const std::uint32_t corner : {a, b, c}) normals_[corner] += area;
  }
}

bool Mesh::intersect_triangle(std::uint32_t triangle, const Ray& ray, const Departure* left, ShapeHit& hit) const {
  if (departs_from(left, triangle)) return false;
  const auto& [ia, ib, ic] = triangles_[triangle];
  const Shear shear(ray.direction);
  const Vec3 a = shear.apply(vertices_[ia] - ray.origin), b = shear.apply(vertices_[ib] - ray.origin),
             c = shear.apply(vertices_[ic] - ray.origin);

  // The ray meets the triangle if it passes all three edges on the same side; an edge itself belongs to both
  // neighbours.
  const double u = turn(b.x, b.y, c.x, c.y), v = turn(c.x, c.y, a.x, a.y), w = turn(a.x, a.y, b.x, b.y);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
  const double area = u + v + w;
  if (area == 0) return false;
  const double t = (u * a.z + v * b.z + w * c.z) / area;
  const bool entering = area < 0;

  // Within rounding of the start, believe what is known of the side and not the sign of t: a ray inside goes out next.
  const double error = 0x1p-48 * (largest_coordinate(ray.origin) + scale_);
  if (left != nullptr && std::abs(t) <= error) {
    if (left->inside == entering) return false;
    hit = {t > 0 ? t : 0.0, triangle, entering};
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

bool Mesh::contains(Vec3 point) const {
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
