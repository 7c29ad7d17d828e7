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

/// Some samples and the emissions they lead to.
struct EmissionColumns {
  static constexpr std::size_t kCapacity = PointColumns::kCapacity;
  std::size_t count = 0;
  PointColumns first, second;
  std::array<std::array<double, kCapacity>, 3> origin, direction, power;

  EmissionSample sample(std::size_t i) const { return {first.at(i), second.at(i)}; }
  void set(std::size_t i, const Emission& emission) {
    for (int a = 0; a < 3; ++a) {
      origin[a][i] = emission.ray.origin[a];
      direction[a][i] = emission.ray.direction[a];
      power[a][i] = emission.power[a];
    }
  }
};

}  // namespace vitrail
