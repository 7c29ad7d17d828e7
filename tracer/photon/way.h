#pragma once
/// Names for the ways of light: two rays have the same name if they met the same faces in the same order and took the
/// same branches there. Where the name changes from one ray to the next, the light behind them tears.

#include "material/surface.h"

namespace vitrail {

/// What light does at a face: it ends there, or goes on.
enum class Turn : std::uint64_t { end, reflect, transmit };

/// The name of the way that leads on from `way` over the face of an arrival. A smooth mesh is one face; a flat one has
/// as many as its triangles have normals.
std::uint64_t on_the_way(const Scene& scene, std::uint64_t way, const Arrival& arrival, Turn turn);

/// The name of the way on which light has become that of one band.
std::uint64_t in_band(std::uint64_t way, std::uint32_t band);

}  // namespace vitrail
