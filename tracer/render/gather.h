#pragma once
/// The end of camera paths: the light that photons brought to what they see, for a whole tile at once.

#include "render/tile.h"

namespace vitrail {

/// Ask the maps for all requests of a tile, which are in the order of its pixels, and add the answers to the film. With
/// settings.gather_disc the answer of beams is their mean over the gather disc in the plane of the surface, of its
/// whole area even where it passes the edge of the surface: what a map of photons answers, without the noise of
/// photons. On curved surfaces beams answer for the place itself.
void gather(const LitWorld& world, const Picture& picture, const Tile& tile, const std::vector<GatherRequest>& requests,
            Film& film);

}  // namespace vitrail
