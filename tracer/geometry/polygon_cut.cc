#include "geometry/polygon_cut.h"

#include <algorithm>

#include "base/diagnostic.h"

namespace vitrail {

namespace {

/// Whether a point lies in a triangle or on its edges, seen along the normal.
bool holds(const std::array<Vec3, 3>& triangle, Vec3 point, Vec3 normal) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = triangle[(k + 1) % 3] - triangle[k];
    if (dot(cross(edge, point - triangle[k]), normal) < 0) return false;
  }
  return true;
}

/// Cut off one ear after the other: a convex corner whose triangle holds no other corner.
std::vector<Triangle> ears(std::vector<std::uint32_t> left, const std::vector<Vec3>& vertices, Vec3 normal) {
  std::vector<Triangle> found;
  while (left.size() > 3) {
    const std::size_t count = left.size();
    const auto is_ear = [&](std::size_t k) {
      const std::uint32_t a = left[(k + count - 1) % count], b = left[k], c = left[(k + 1) % count];
      const std::array<Vec3, 3> corners = {vertices[a], vertices[b], vertices[c]};
      if (!(dot(cross(corners[1] - corners[0], corners[2] - corners[1]), normal) > 0)) return false;
      return std::none_of(left.begin(), left.end(), [&](std::uint32_t each) {
        return each != a && each != b && each != c && holds(corners, vertices[each], normal);
      });
    };
    std::size_t ear = 0;
    while (ear < count && !is_ear(ear)) ++ear;
    if (ear == count) return {};
    found.push_back({left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  found.push_back({left[0], left[1], left[2]});
  return found;
}

}  // namespace

std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& polygon, const std::vector<Vec3>& vertices) {
  std::vector<Triangle> fan;
  for (std::size_t i = 2; i < polygon.size(); ++i) fan.push_back({polygon[0], polygon[i - 1], polygon[i]});
  if (fan.size() < 2) return fan;

  // Twice the vector area of the whole outline (Newell's sum); a fan is right where none of its triangles turns back.
  Vec3 normal;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    normal += cross(vertices[polygon[i]], vertices[polygon[(i + 1) % polygon.size()]]);
  const auto area = [&](const Triangle& t) {
    return cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]);
  };
  const bool has_area = std::any_of(fan.begin(), fan.end(), [&](const Triangle& t) { return area(t) != Vec3{}; });
  if (has_area && normal == Vec3{}) return {};
  const auto turns_back = [&](const Triangle& t) { return dot(area(t), normal) < 0; };
  return std::none_of(fan.begin(), fan.end(), turns_back) ? fan : ears(polygon, vertices, normal);
}

void add_polygon(MeshData& mesh, const std::vector<std::uint32_t>& corners, const std::string& where) {
  if (corners.size() < 3) return;
  const std::vector<Triangle> cut = triangles_of(corners, mesh.vertices);
  if (cut.empty()) throw InputError({{where, "has a polygon that crosses itself", "split it into triangles"}});
  mesh.triangles.insert(mesh.triangles.end(), cut.begin(), cut.end());
}

}  // namespace vitrail
