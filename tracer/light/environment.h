#pragma once
/// Radiance from every direction, constant or from an image.

#include "light/emission.h"

namespace vitrail {

/// A direction drawn with the cosine about `normal`, or from the image in proportion to what it sends; `irradiance` is
/// divided by the density of the draw.
Illumination illuminate(const EnvironmentLight& light, Vec3 normal, const UnitPoint& sample);

/// Photons from every direction through a window that covers the target.
struct EnvironmentChart {
  Target target;
  Surroundings surroundings;
  EnvironmentLight light;
  Rgb power;  // through the disc around the target from all directions, W
};

EnvironmentChart aim(const EnvironmentLight& light, const Target& target, const Surroundings& surroundings);
Emission emit(const EnvironmentChart& chart, const EmissionSample& sample);

}  // namespace vitrail
