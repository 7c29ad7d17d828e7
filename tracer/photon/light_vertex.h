#pragma once
/// A photon between two surfaces, for the strategies that follow one photon at a time.

#include "photon/path_signature.h"

namespace vitrail {

struct LightVertex {
  PathState path{};         // the weight is the flux, W
  double least = 0;         // W; fainter branches live by chance, or are cut off
  double share = 1;         // of the photon that left the light, by how it divided at faces
  std::uint32_t index = 0;  // of the photon in its chart, for random choices at rough faces
  PathSignature signature = PathSignature::at_light;

  bool has_bounced() const { return path.depth.faces() > 0; }
};

/// Whether a surface of this material may show photons somewhere.
inline bool can_be_diffuse(const Material& material) { return !is_black(texture_peak(material.diffuse)); }

}  // namespace vitrail
