#include "light/area.h"

#include <algorithm>

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

// Where along one edge of a rectangle, from -1 to 1, its normals may meet the target: inside its sphere and its box.
struct Stretch {
  double low, high;
  double middle() const { return (low + high) / 2; }
  double half() const { return std::max(0.0, high - low) / 2; }
};

Stretch stretch_along(Vec3 edge, Vec3 center, const Target& target) {
  const Vec3 along = edge * (1 / length_squared(edge));
  const double at = dot(target.bound.center - center, along), reach = target.bound.radius * length(along);
  double low = kInfinity, high = -kInfinity;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{corner & 1 ? target.box.max.x : target.box.min.x, corner & 2 ? target.box.max.y : target.box.min.y,
                 corner & 4 ? target.box.max.z : target.box.min.z};
    low = std::min(low, dot(p - center, along));
    high = std::max(high, dot(p - center, along));
  }

  // Rounding must leave nothing out: widen by a billionth of the lamp.
  constexpr double kMargin = 0x1p-30;
  return {std::max({-1.0, low - kMargin, at - reach - kMargin}), std::min({1.0, high + kMargin, at + reach + kMargin})};
}

// The part of a rectangle whose normals may meet the target; no area where none does.
Window part_before(const Window& lamp, const Target& target) {
  const Stretch u = stretch_along(lamp.u, lamp.center, target), v = stretch_along(lamp.v, lamp.center, target);
  return {lamp.center + lamp.u * u.middle() + lamp.v * v.middle(), lamp.u * u.half(), lamp.v * v.half(), false};
}

bool contains(const Window& window, Vec3 point) {
  const Vec3 d = point - window.center;
  const double a = dot(d, window.u) / length_squared(window.u), b = dot(d, window.v) / length_squared(window.v);
  return window.round ? a * a + b * b <= 1 : std::abs(a) <= 1 && std::abs(b) <= 1;
}

// Whether a place before a lamp sees it so wide that most of its area is far off: its foot is on the lamp, nearer than
// the lamp's edges are to its middle.
bool is_near(const Window& lamp, Vec3 foot, double height) {
  return height > 0 && height < std::min(length(lamp.u), length(lamp.v)) && contains(lamp, foot);
}

// Draw directions, not places of the lamp: evenly from the cone around its foot that holds the whole lamp. Those that
// miss it bring nothing. More than half of a wide disc's cone is lamp.
Illumination illuminate_near(const AreaLight& light, const Lamp& lamp, Vec3 point, double height,
                             const UnitPoint& sample) {
  const auto& [window, normal] = lamp;
  const double half = window.round ? length(window.u) : std::hypot(length(window.u), length(window.v));
  const double reach = length(point - normal * height - window.center) + half, slant = std::hypot(height, reach);
  const double one_minus_cos = reach / slant * (reach / (slant + height));
  const Vec3 direction = in_cone(-normal, surface_frame(-normal), one_minus_cos, sample);
  const double distance = height / -dot(direction, normal);
  if (!contains(window, point + direction * distance)) return {direction, distance, {}};
  return {direction, distance, light.radiance * (2 * M_PI * one_minus_cos)};
}

}  // namespace

Illumination illuminate(const AreaLight& light, Vec3 point, const UnitPoint& sample) {
  const Lamp lamp = lamp_of(light);
  const auto& [window, normal] = lamp;
  const double height = dot(point - window.center, normal);
  if (light.collimated) {
    // Follow the normal back to the lamp.
    if (!(height > 0) || !contains(window, point)) return {-normal, 0, {}};
    return {-normal, height, light.irradiance};
  }
  if (is_near(window, point - normal * height, height)) return illuminate_near(light, lamp, point, height, sample);
  const Vec3 way = window.at(sample) - point;
  const double distance = length(way);
  if (distance == 0) return {};
  const Vec3 toward = way / distance;
  const double cosine = -dot(toward, normal);
  if (!(cosine > 0)) return {toward, distance, {}};
  return {toward, distance, light.radiance * (window.area() * cosine / (distance * distance))};
}

AreaChart aim(const AreaLight& light, const Target& target) {
  const auto [lamp, normal] = lamp_of(light);
  const Window window = light.collimated && !lamp.round ? part_before(lamp, target) : lamp;
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
