#pragma once
/// A lamp with an area: one-sided and Lambertian, or collimated along its normal.

#include "light/emission.h"
#include "light/window.h"

namespace vitrail {

Illumination illuminate(const AreaLight& light, Vec3 point, const UnitPoint& sample);

/// Photons into the cone around the target from everywhere on the lamp; or along the normal, and then of a rectangle
/// only from the part before the target.
struct AreaChart {
  Window lamp;
  Vec3 normal;
  bool collimated = false;
  BoundingSphere target;
  Rgb emitted;  // radiance, or irradiance if collimated
  Rgb power;    // an estimate for sharing out photons; a collimated lamp's exact power
  Vec3 lift{};  // off what the lamp is mounted on, by what rounding may do
};

AreaChart aim(const AreaLight& light, const Target& target);
Emission emit(const AreaChart& chart, const EmissionSample& sample);

}  // namespace vitrail
