#pragma once
/// Polygons of a mesh cut into triangles: fans where a polygon is convex, ears where it is not.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh_file.h"

namespace vitrail {

using Triangle = std::array<std::uint32_t, 3>;

/// The triangles of one flat polygon, with its sense of turning: the same as those of the Python side. Empty for an
/// outline that crosses itself, as far as its area or a missing ear tells, and for fewer than three corners.
std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& polygon, const std::vector<Vec3>& vertices);

/// Add a polygon to a mesh whose vertices are known; fewer than three corners, left by exporters, enclose nothing.
/// Throws InputError, with the place in the file, where it crosses itself.
void add_polygon(MeshData& mesh, const std::vector<std::uint32_t>& corners, const std::string& where);

}  // namespace vitrail
