#include "light/environment.h"

#include <limits>

#include "light/sampling.h"
#include "light/window.h"

namespace vitrail {

Illumination illuminate(const EnvironmentLight& light, Vec3 normal, const UnitPoint& sample) {
  if (light.image) {
    const SkyImage::Draw draw = light.image->draw(sample.a, sample.b);
    if (!(draw.density > 0)) return {};
    return {draw.direction, std::numeric_limits<double>::infinity(), draw.radiance * (1 / draw.density)};
  }
  const double x = sample.x, y = sample.y;
  const double cosine = std::sqrt(std::max(0.0, 1 - (x * x + y * y)));
  const SurfaceFrame frame = surface_frame(normal);
  const Vec3 toward = normalise(normal * cosine + frame.u * x + frame.v * y);
  const double facing = dot(toward, normal);
  if (!(facing > 0)) return {};
  return {toward, std::numeric_limits<double>::infinity(), light.radiance * (M_PI / facing)};
}

EnvironmentChart aim(const EnvironmentLight& light, const Target& target, const Surroundings& surroundings) {
  const double disc = M_PI * target.bound.radius * target.bound.radius;
  const Rgb total = light.image ? light.image->total() : light.radiance * (4 * M_PI);
  return {target, surroundings, light, total * disc};
}

Emission emit(const EnvironmentChart& chart, const EmissionSample& sample) {
  // Light comes from where the draw points to.
  Vec3 toward = in_cone({0, 0, 1}, surface_frame({0, 0, 1}), 2, sample.second);
  Rgb radiance = chart.light.radiance;
  double density = 1 / (4 * M_PI);
  if (chart.light.image) {
    const SkyImage::Draw draw = chart.light.image->draw(sample.second.a, sample.second.b);
    toward = draw.direction;
    radiance = draw.radiance;
    density = draw.density;
  }
  if (!(density > 0)) return {};
  const Window window = window_on(chart.target, -toward);
  const Vec3 start = upstream_of(window.at(sample.first), -toward, chart.surroundings);
  return {{before_planes(start, -toward, chart.surroundings), -toward}, radiance * (window.area() / density)};
}

}  // namespace vitrail
