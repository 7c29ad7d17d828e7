#include "geometry/mesh_closed.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace vitrail {

namespace {

/// For each vertex the first one at the same position.
std::vector<std::uint32_t> unite_positions(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tuple(vertices[i].x, vertices[i].y, vertices[i].z, i); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

std::string fault_of_closed_mesh(const MeshData& mesh) {
  const std::vector<std::uint32_t> vertex = unite_positions(mesh.vertices);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  double volume = 0;
  const Vec3 reference = mesh.vertices.empty() ? Vec3{} : mesh.vertices[0];
  for (const auto& corners : mesh.triangles) {
    const std::uint32_t a = vertex[corners[0]], b = vertex[corners[1]], c = vertex[corners[2]];
    if (a == b || b == c || c == a) continue;
    edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
    const Vec3 pa = mesh.vertices[a] - reference, pb = mesh.vertices[b] - reference, pc = mesh.vertices[c] - reference;
    volume += dot(pa, cross(pb, pc));
  }

  // Every edge must be there once in each direction.
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    return "has an edge with two triangles on the same side";
  for (const auto& [from, to] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::pair{to, from})) return "has a hole";
  return volume > 0 ? "" : "is inside out";
}

}  // namespace vitrail
