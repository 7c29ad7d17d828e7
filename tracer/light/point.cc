#include "light/point.h"

#include "light/sampling.h"

namespace vitrail {
namespace {

Illumination from_position(Vec3 position, Rgb intensity, Vec3 point) {
  const Vec3 way = position - point;
  const double distance = length(way);
  if (distance == 0) return {};
  return {way / distance, distance, intensity * (1 / (distance * distance))};
}

double cos_of_spot(const SpotLight& light) { return std::cos(light.cone_deg * (M_PI / 360)); }

ConeChart cone_around(Vec3 position, const Target& target, Rgb intensity) {
  const Vec3 way = target.bound.center - position;
  const double distance = length(way);
  ConeChart chart;
  chart.position = position;
  chart.axis = distance > 0 ? way / distance : Vec3{0, 0, 1};
  chart.frame = surface_frame(chart.axis);
  chart.one_minus_cos = one_minus_cos_of(target.bound.radius, distance);
  chart.power = intensity * (2 * M_PI * chart.one_minus_cos);
  return chart;
}

}  // namespace

Illumination illuminate(const PointLight& light, Vec3 point, const UnitPoint&) {
  return from_position(light.position, light.intensity, point);
}

Illumination illuminate(const SpotLight& light, Vec3 point, const UnitPoint&) {
  Illumination found = from_position(light.position, light.intensity, point);
  if (dot(-found.toward, light.direction) < cos_of_spot(light)) found.irradiance = {};
  return found;
}

ConeChart aim(const PointLight& light, const Target& target) {
  return cone_around(light.position, target, light.intensity);
}

ConeChart aim(const SpotLight& light, const Target& target) {
  ConeChart chart = cone_around(light.position, target, light.intensity);
  const double cos_spot = cos_of_spot(light);
  chart.limit_axis = light.direction;
  chart.limit_cos = cos_spot;

  // Sample the spot's own cone if it is the narrower one; the limit is then the target itself, which the hit decides.
  const double one_minus_cos_spot = 1 - cos_spot;
  if (one_minus_cos_spot < chart.one_minus_cos) {
    chart.axis = light.direction;
    chart.frame = surface_frame(chart.axis);
    chart.one_minus_cos = one_minus_cos_spot;
    chart.limit_cos = -2;
    chart.power = light.intensity * (2 * M_PI * one_minus_cos_spot);
  }
  return chart;
}

}  // namespace vitrail
