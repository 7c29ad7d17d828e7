#pragma once
/// Where a light path ends on a surface that can be diffuse.

#include "photon/light_vertex.h"

namespace vitrail {

struct Landing {
  Vec3 position;
  Vec3 normal;  // on the side where the light arrived
  Rgb flux;     // what arrives, W
  Rgb kept;     // what no mirror or glass of this surface sends on, W: the ledger takes it as stored
  PathSignature signature = PathSignature::at_light;  // from the light to here, this face included
};

/// What takes the landings of a tree.
class LandingSink {
 public:
  virtual ~LandingSink() = default;
  virtual void land(const Landing& landing) = 0;
};

}  // namespace vitrail
