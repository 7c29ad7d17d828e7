#pragma once
/// Solids that share no place with another: a ray inside one comes to its own face before any other.

#include <cstdint>
#include <vector>

#include "geometry/primitive.h"

namespace vitrail {

/// By primitive: whether it is one closed solid, and no face of another enters its box. Those of `left_out` stay out of
/// it: they are neither alone nor in the way.
std::vector<bool> solids_alone(const std::vector<Primitive>& primitives, const std::vector<std::uint32_t>& left_out);

}  // namespace vitrail
