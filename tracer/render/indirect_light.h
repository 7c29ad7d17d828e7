#pragma once
/// Light that comes to a surface by way of other diffuse surfaces.

#include "photon/photon_maps.h"
#include "render/direct_light.h"

namespace vitrail {

/// What camera paths ask about photons.
struct LightMaps {
  PhotonMaps caustic, indirect;
};

/// A world whose photons have been traced.
struct LitWorld : World {
  const LightMaps& maps;
};

/// Indirect irradiance, W/m2, from the maps of one half, at a place that a camera path sees:
/// settings.final_gather_rays are drawn with the cosine, each of which ends on a diffuse surface lit directly, by
/// caustics and indirectly; with 0 rays straight from the map.
Rgb indirect_irradiance(const LitWorld& world, int half, const ShadingPoint& at, const PathState& seen_by,
                        SampleDraw draw);

}  // namespace vitrail
