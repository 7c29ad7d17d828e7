#pragma once
/// Light that comes to a surface by way of other diffuse surfaces.

#include "photon/indirect.h"
#include "photon/pass.h"
#include "render/direct_light.h"

namespace vitrail {

/// What camera paths ask about photons.
struct LightMaps {
  PhotonMaps caustic;
  IndirectMaps indirect;
};

/// A place on a diffuse surface seen by the camera.
struct SeenPoint {
  Vec3 point, normal;  // unit, on the viewer's side
  Departures departures;
  MediumSet media;
  std::uint32_t band = 0;
  bool band_chosen = false;
};

/// Indirect irradiance, W/m2, from the maps of one half: settings.final_gather_rays looks around with the cosine, each
/// of which ends on a diffuse surface lit directly, by caustics and indirectly; with 0 rays straight from the map.
Rgb indirect_irradiance(const Scene& scene, const Intersector& intersector, const LightMaps& maps, int half,
                        const SeenPoint& seen, LightDraw draw);

}  // namespace vitrail
