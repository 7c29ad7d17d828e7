#include "light/directional.h"

#include <limits>

#include "light/sampling.h"

namespace vitrail {
namespace {

double one_minus_cos_of_sun(const DirectionalLight& light) {
  const double sine = std::sin(light.angular_diameter_deg * (M_PI / 720));
  return 2 * sine * sine;
}

// Uniform radiance L over the sun's disc gives irradiance L pi sin^2 on a facing surface; each direction, taken alone,
// stands for L times the disc's solid angle.
double share_of_a_direction(double one_minus_cos) { return 2 / (2 - one_minus_cos); }

Window upstream_window(const Target& target, Vec3 direction, const BoundingSphere& surroundings) {
  Window window = window_on(target, direction);
  window.center = upstream_of(window.center, direction, surroundings);
  return window;
}

}  // namespace

Illumination illuminate(const DirectionalLight& light, Vec3, const UnitPoint& sample) {
  if (light.angular_diameter_deg == 0) return {-light.direction, kInfinity, light.irradiance};
  const double one_minus_cos = one_minus_cos_of_sun(light);
  const Vec3 toward = in_cone(-light.direction, surface_frame(light.direction), one_minus_cos, sample);
  return {toward, kInfinity, light.irradiance * share_of_a_direction(one_minus_cos)};
}

DirectionalChart aim(const DirectionalLight& light, const Target& target, const Surroundings& surroundings) {
  DirectionalChart chart;
  chart.direction = light.direction;
  chart.one_minus_cos = one_minus_cos_of_sun(light);
  chart.window = upstream_window(target, light.direction, surroundings);
  chart.target = target;
  chart.surroundings = surroundings;
  if (chart.one_minus_cos == 0) {
    chart.surroundings.planes = planes_before(chart.window, chart.direction, surroundings.planes);
  }
  chart.power = light.irradiance * (chart.window.area() * share_of_a_direction(chart.one_minus_cos));
  return chart;
}

Emission emit_from_sun(const DirectionalChart& chart, const EmissionSample& sample) {
  // Turn the window to face the chosen direction of the sun's disc.
  const Vec3 direction = in_cone(chart.direction, surface_frame(chart.direction), chart.one_minus_cos, sample.second);
  const Window window = upstream_window(chart.target, direction, chart.surroundings);
  const Vec3 start = before_planes(window.at(sample.first), direction, chart.surroundings);
  return {{start, direction}, chart.power * (window.area() / chart.window.area())};
}

}  // namespace vitrail
