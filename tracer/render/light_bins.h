#pragma once
/// The other way to see photons: each is counted in the very pixel that sees it, with no disc and no blur.

#include "base/monitor.h"
#include "geometry/accel.h"
#include "photon/photon_map.h"
#include "render/film.h"

namespace vitrail {

/// From so many photons a pixel on `auto` counts photons in pixels. On the ball lens the map with its usual radius
/// (which shrinks as the cube root of the photons) has .24, .45 and .76 of the bins' error at .6, 6 and 61 photons a
/// pixel: the ratio grows as their fourth root and passes 1 near 190.
inline constexpr double kPhotonsForBins = 200;

/// Whether the scene's solver is `light_bins`, or `auto` with photons enough for it.
bool takes_light_bins(const Scene& scene);

/// Whether the caustics that the camera sees directly are counted in its pixels, by this solver or by `beams`.
bool counts_in_pixels(const Scene& scene);

/// Add the photons of a map to the caustic layer of one half, wherever the camera sees their surface directly; what it
/// sees by way of mirrors and glass is left to the map. A photon of flux F on a surface of albedo d brings its pixel
/// d / pi F times the pixels per square metre that the surface covers there: the exact mean over the pixel, with the
/// noise of single photons and no bias. The order of addition is that of the map: the same bits for any threads.
/// Returns the CPU seconds of all threads.
double deposit_in_pixels(const Scene& scene, const Intersector& intersector, const PhotonMap& map, int half,
                         unsigned threads, Monitor& monitor, Film& film);

}  // namespace vitrail
