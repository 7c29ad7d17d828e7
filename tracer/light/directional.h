#pragma once
/// Light from infinity, parallel or from a disc in the sky (the sun).

#include "light/emission.h"
#include "light/window.h"

namespace vitrail {

Illumination illuminate(const DirectionalLight& light, Vec3 point, const UnitPoint& sample);

/// Photons through a window that covers the target as seen along the light; a sun has one window for each direction.
struct DirectionalChart {
  Vec3 direction;
  double one_minus_cos = 0;  // of the sun's angular radius; 0 for parallel light
  Window window;             // across `direction`, upstream of everything
  Target target;
  Surroundings surroundings;  // for parallel light only those planes that are crossed before the window
  Rgb power;                  // through the window, W
};

DirectionalChart aim(const DirectionalLight& light, const Target& target, const Surroundings& surroundings);
Emission emit_from_sun(const DirectionalChart& chart, const EmissionSample& sample);

inline Emission emit(const DirectionalChart& chart, const EmissionSample& sample) {
  if (chart.one_minus_cos > 0) return emit_from_sun(chart, sample);
  const Vec3 start = chart.window.at(sample.first);
  return {{before_planes(start, chart.direction, chart.surroundings), chart.direction}, chart.power};
}

}  // namespace vitrail
