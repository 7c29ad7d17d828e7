#pragma once
/// Triangles from PLY (text, and bytes of either order) and OBJ files. Text keeps every digit of a double, which the
/// libraries at hand do not (docs/decisions).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec3.h"

namespace vitrail {

struct MeshData {
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;  // one a vertex, or none
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Read by the ending of the name; polygons become fans, concave ones ears. Throws InputError with the file and line or
/// byte of the fault.
MeshData read_mesh_file(const std::string& path);

}  // namespace vitrail
