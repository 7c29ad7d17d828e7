#pragma once
/// A light without extent that shines in every direction, or inside a cone (spot).

#include "light/emission.h"

namespace vitrail {

Illumination illuminate(const PointLight& light, Vec3 point, const UnitPoint& sample);
Illumination illuminate(const SpotLight& light, Vec3 point, const UnitPoint& sample);

/// Photons inside the narrower of two cones: the one around the target, and the one of the spot.
struct ConeChart {
  Vec3 position, axis;
  SurfaceFrame frame;        // about the axis
  double one_minus_cos = 2;  // of the half angle that is sampled
  Vec3 limit_axis;           // photons outside the other cone carry nothing
  double limit_cos = -2;
  Rgb power;  // into the sampled cone, W
};

ConeChart aim(const PointLight& light, const Target& target);
ConeChart aim(const SpotLight& light, const Target& target);

inline Emission emit(const ConeChart& chart, const EmissionSample& sample) {
  const Vec3 direction = in_cone(chart.axis, chart.frame, chart.one_minus_cos, sample.first);
  const bool lit = dot(direction, chart.limit_axis) >= chart.limit_cos;
  return {{chart.position, direction}, lit ? chart.power : Rgb{}};
}

}  // namespace vitrail
