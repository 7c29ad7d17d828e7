#pragma once
/// A photon between two events.

#include "photon/path_signature.h"

namespace vitrail {

struct Flight {
  Ray ray;
  Departures departures;
  MediumSet media;
  Rgb flux;
  double least = 0;  // W; a branch below this is cut off
  std::uint32_t band = 0;
  bool band_chosen = false;  // before the first dispersive face all bands share one path
  Depth depth{};
  std::uint32_t index = 0;  // of the photon in its chart, for random choices on its way
  PathSignature signature = PathSignature::at_light;

  bool has_bounced() const { return depth.faces() > 0; }
};

/// Whether a surface of this material may show photons somewhere.
inline bool can_be_diffuse(const Material& material) { return !is_black(texture_peak(material.diffuse)); }

/// Whether the bands of light have different indices in the medium of an object (kAir for none).
bool tells_bands_apart(const Scene& scene, std::uint32_t object);

}  // namespace vitrail
