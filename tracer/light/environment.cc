#include "light/environment.h"

#include <limits>

#include "light/sampling.h"
#include "light/window.h"

namespace vitrail {

Illumination illuminate(const EnvironmentLight& light, Vec3 normal, const UnitPoint& sample) {
  const double x = sample.x, y = sample.y;
  const double cosine = std::sqrt(std::max(0.0, 1 - (x * x + y * y)));
  const SurfaceFrame frame = surface_frame(normal);
  const Vec3 toward = normalise(normal * cosine + frame.u * x + frame.v * y);
  const double facing = dot(toward, normal);
  if (!(facing > 0)) return {};
  return {toward, std::numeric_limits<double>::infinity(), light.radiance * (M_PI / facing)};
}

EnvironmentChart aim(const EnvironmentLight& light, const Target& target, const BoundingSphere& surroundings) {
  const double disc = M_PI * target.bound.radius * target.bound.radius;
  return {target, surroundings, light.radiance, light.radiance * (4 * M_PI * disc)};
}

Emission emit(const EnvironmentChart& chart, const EmissionSample& sample) {
  const Vec3 direction = in_cone({0, 0, 1}, surface_frame({0, 0, 1}), 2, sample.second);
  const Window window = window_on(chart.target, direction);
  const Vec3 start = upstream_of(window.at(sample.first), direction, chart.surroundings);
  return {{start, direction}, chart.radiance * (4 * M_PI * window.area())};
}

}  // namespace vitrail
