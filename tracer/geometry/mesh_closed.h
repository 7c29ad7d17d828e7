#pragma once
/// Whether triangles enclose something: what glass needs.

#include <string>

#include "scene/mesh_data.h"

namespace vitrail {

/// Empty if every edge has exactly one triangle on either side and the outside is outside; else what is wrong.
/// Vertices count as one where their positions are equal.
std::string fault_of_closed_mesh(const MeshData& mesh);

}  // namespace vitrail
