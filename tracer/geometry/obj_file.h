#pragma once
/// OBJ files: vertices, normals and faces; groups, materials and texture coordinates are passed over.

#include <string>

#include "geometry/mesh_file.h"

namespace vitrail {

/// What the text of an OBJ file holds; `path` is for messages. Throws InputError with the line of the fault.
MeshData read_obj(const std::string& path, std::string text);

}  // namespace vitrail
