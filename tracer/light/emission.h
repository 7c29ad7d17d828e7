#pragma once
/// What every kind of light answers: the light it sends to a point, and the photons it sends towards a target.

#include "base/ray.h"
#include "light/sampling.h"
#include "light/target.h"

namespace vitrail {

/// Light arriving at a point from one place of a light.
struct Illumination {
  Vec3 toward;          // unit, from the point to the light
  double distance = 0;  // how far a shadow ray must be free; infinity for light from infinity
  Rgb irradiance;       // W/m2 on a surface that faces `toward`; black if the light does not reach the point
};

/// A photon as it leaves the light. `power` is what the whole chart would carry if all its photons were like this one:
/// the photon's own power is power / count.
struct Emission {
  Ray ray;
  Rgb power;
};

/// The random part of an emission: a position, and a direction where a light has both to choose.
struct EmissionSample {
  UnitPoint first, second;
};

}  // namespace vitrail
