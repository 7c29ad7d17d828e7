#pragma once
/// The triangles of a mesh in its own axes, as the lowered scene holds them.

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace vitrail {

struct MeshData {
  std::vector<Vec3> vertices;  // metres
  std::vector<Vec3> normals;   // one a vertex, or none
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace vitrail
