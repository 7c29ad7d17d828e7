#pragma once
/// The other way to see photons: each is counted in the very pixel that sees it, with no disc and no blur.

#include "base/workers.h"
#include "geometry/world.h"
#include "photon/photon_maps.h"
#include "render/film.h"

namespace vitrail {

/// Whether the caustics that the camera sees directly are counted in its pixels, by this solver or by `beams`. Means
/// over gather discs are looked up.
inline bool counts_in_pixels(const Scene& scene, const PhotonMaps& caustic) {
  return caustic.statistics.solver != Solver::photon_map && !scene.settings.gather_disc;
}

/// Add the photons of a map to the caustic layer of one half, wherever the camera sees their surface directly; what it
/// sees by way of mirrors and glass is left to the map. A photon of flux F on a surface of albedo d brings its pixel
/// d / pi F times the pixels per square metre that the surface covers there: the exact mean over the pixel, with the
/// noise of single photons and no bias. The order of addition is that of the map: the same bits for any threads.
/// Returns the CPU seconds of all threads.
double deposit_in_pixels(const World& world, const Picture& picture, const PhotonMap& map, int half,
                         const Workers& workers, Film& film);

/// How many blocks of work, units of the monitor's phase, that is.
std::size_t deposit_blocks(const PhotonMap& map);

}  // namespace vitrail
