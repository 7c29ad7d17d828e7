#include "light/area.h"

#include "light/sampling.h"

namespace vitrail {
namespace {

struct Lamp {
  Window window;
  Vec3 normal;
};

Lamp lamp_of(const RectangleShape& r) { return {{r.center, r.u, r.v, false}, normalise(cross(r.u, r.v))}; }

Lamp lamp_of(const DiscShape& d) {
  const SurfaceFrame frame = surface_frame(d.normal);
  return {{d.center, frame.u * d.radius, frame.v * d.radius, true}, d.normal};
}

Lamp lamp_of(const AreaLight& light) {
  return std::visit([](const auto& shape) { return lamp_of(shape); }, light.shape);
}

bool contains(const Window& window, Vec3 point) {
  const Vec3 d = point - window.center;
  const double a = dot(d, window.u) / length_squared(window.u), b = dot(d, window.v) / length_squared(window.v);
  return window.round ? a * a + b * b <= 1 : std::abs(a) <= 1 && std::abs(b) <= 1;
}

}  // namespace

Illumination illuminate(const AreaLight& light, Vec3 point, const UnitPoint& sample) {
  const auto [window, normal] = lamp_of(light);
  if (light.collimated) {
    // Follow the normal back to the lamp.
    const double height = dot(point - window.center, normal);
    if (!(height > 0) || !contains(window, point)) return {-normal, 0, {}};
    return {-normal, height, light.irradiance};
  }
  const Vec3 way = window.at(sample) - point;
  const double distance = length(way);
  if (distance == 0) return {};
  const Vec3 toward = way / distance;
  const double cosine = -dot(toward, normal);
  if (!(cosine > 0)) return {toward, distance, {}};
  return {toward, distance, light.radiance * (window.area() * cosine / (distance * distance))};
}

AreaChart aim(const AreaLight& light, const Target& target) {
  const auto [window, normal] = lamp_of(light);
  AreaChart chart{window, normal, light.collimated, target.bound, light.collimated ? light.irradiance : light.radiance,
                  {}};
  const double distance = length(target.bound.center - window.center);
  const double solid_angle = light.collimated ? 1 : 2 * M_PI * one_minus_cos_of(target.bound.radius, distance);
  chart.power = chart.emitted * (window.area() * solid_angle);

  // A lamp flush with a wall shines into the room: rounding must not start a photon behind the wall.
  const double reach = largest_coordinate(window.center) + largest_coordinate(window.u) + largest_coordinate(window.v);
  chart.lift = normal * (0x1p-47 * reach);
  return chart;
}

Emission emit(const AreaChart& chart, const EmissionSample& sample) {
  const Vec3 position = chart.lamp.at(sample.first) + chart.lift;
  if (chart.collimated) return {{position, chart.normal}, chart.power};

  // Aim from this place of the lamp; the cosine at the lamp weighs the photon.
  const Vec3 way = chart.target.center - position;
  const double distance = length(way);
  const double one_minus_cos = one_minus_cos_of(chart.target.radius, distance);
  const Vec3 axis = distance > 0 ? way / distance : chart.normal;
  const Vec3 direction = in_cone(axis, surface_frame(axis), one_minus_cos, sample.second);
  const double cosine = dot(direction, chart.normal);
  if (!(cosine > 0)) return {{position, direction}, {}};
  return {{position, direction}, chart.emitted * (chart.lamp.area() * 2 * M_PI * one_minus_cos * cosine)};
}

}  // namespace vitrail
