#pragma once
/// A path between two surfaces: the same for photons, camera paths and random walks.

#include "base/ray.h"
#include "geometry/hit.h"
#include "geometry/medium_stack.h"

namespace vitrail {

/// Which index of refraction a path meets: that of its band, or the material's camera_ior (paper.disperse_camera off).
enum class IorSource { band, camera };

struct PathState {
  Ray ray;
  Departures departures{};  // the faces that the ray starts on
  MediumSet media{};        // the solids that it is in
  Rgb weight{1, 1, 1};      // flux of a photon, W; throughput of a camera path
  std::uint32_t band = 0;
  bool band_chosen = false;  // before the first dispersive face all bands share one path
  IorSource ior = IorSource::band;
  Depth depth{};  // since the last diffuse surface
};

/// Whether the bands of light have different indices in the medium of an object (kAir for none).
bool is_dispersive(const Scene& scene, std::uint32_t object);

}  // namespace vitrail
