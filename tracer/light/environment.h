#pragma once
/// Constant radiance from every direction.

#include "light/emission.h"

namespace vitrail {

/// A direction about `normal` with density proportional to the cosine; `irradiance` is divided by that density.
Illumination illuminate(const EnvironmentLight& light, Vec3 normal, const UnitPoint& sample);

/// Photons from every direction through a window that covers the target.
struct EnvironmentChart {
  Target target;
  BoundingSphere surroundings;
  Rgb radiance;
  Rgb power;  // through the disc around the target from all directions, W
};

EnvironmentChart aim(const EnvironmentLight& light, const Target& target, const BoundingSphere& surroundings);
Emission emit(const EnvironmentChart& chart, const EmissionSample& sample);

}  // namespace vitrail
