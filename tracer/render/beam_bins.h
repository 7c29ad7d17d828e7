#pragma once
/// Beams in the pixels that see the surface they land on: exact areas, no samples of the pixel.

#include "base/workers.h"
#include "geometry/world.h"
#include "photon/beams/beam_map.h"
#include "render/film.h"

namespace vitrail {

/// Add the beams of a map to the caustic layer of one half, wherever the camera sees their surface directly; what it
/// sees by way of mirrors and glass is left to the map. Each beam is cut along the edges of the pixels, and each piece
/// brings its pixel d / pi times its flux times the pixels per square metre that the surface covers there. The order of
/// addition is that of the map: the same bits for any threads. Returns the CPU seconds of all threads.
double deposit_beams(const World& world, const Picture& picture, const BeamMap& map, int half, const Workers& workers,
                     Film& film);

/// How many blocks of work, units of the monitor's phase, that is.
std::size_t deposit_blocks(const BeamMap& map);

}  // namespace vitrail
