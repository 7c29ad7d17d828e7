#include "scene/centre.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vitrail {

namespace {

std::optional<Place> place_of(const Shape& shape) {
  return std::visit([](const auto& one) { return one.place(); }, shape);
}

/// Planes only: stand where the camera stands, in units of its distance to the planes.
Place place_of_camera(const Scene& scene) {
  Place place{scene.camera.position, 0};
  for (const Object& object : scene.objects)
    if (const auto* plane = std::get_if<PlaneShape>(&object.shape))
      place.size = std::max(place.size, std::abs(dot(plane->point - place.centre, plane->normal)));
  return place;
}

/// The centre of the small things: each weighs 1/size^2, so that a ball on a planet is not drawn into the planet.
Vec3 weighted_centre(const std::vector<Place>& places, double& spread) {
  double smallest = places.front().size;
  for (const Place& place : places) smallest = std::min(smallest, place.size);
  const auto weight = [&](const Place& place) { return (smallest / place.size) * (smallest / place.size); };

  Vec3 sum;
  double total = 0;
  for (const Place& place : places) {
    sum += place.centre * weight(place);
    total += weight(place);
  }
  const Vec3 centre = sum / total;

  // Their mean distance from that centre, counting their own size.
  double reach = 0;
  for (const Place& place : places) reach += weight(place) * (largest_coordinate(place.centre - centre) + place.size);
  spread = reach / total;
  return centre;
}

struct MoveEmitter {
  Vec3 by;
  void operator()(DirectionalLight&) const {}
  void operator()(PointLight& light) const { light.position += by; }
  void operator()(SpotLight& light) const { light.position += by; }
  void operator()(AreaLight& light) const {
    std::visit([&](auto& shape) { shape.move(by); }, light.shape);
  }
  void operator()(EnvironmentLight&) const {}
};

}  // namespace

void centre_scene(Scene& scene) {
  std::vector<Place> places;
  for (const Object& object : scene.objects)
    if (const std::optional<Place> place = place_of(object.shape)) places.push_back(*place);
  if (places.empty()) places.push_back(place_of_camera(scene));
  for (const Place& place : places)
    if (!(place.size > 0)) return;

  // Round to a power of two of 16 to 32 times the spread: nothing within 8 spreads of the origin moves.
  double spread = 0;
  const Vec3 centre = weighted_centre(places, spread);
  const double quantum = std::ldexp(1.0, std::ilogb(spread) + 5);
  if (!std::isfinite(quantum) || !is_finite(centre)) return;
  const Vec3 shift{std::round(centre.x / quantum) * quantum, std::round(centre.y / quantum) * quantum,
                   std::round(centre.z / quantum) * quantum};
  if (shift == Vec3{}) return;

  scene.shift = scene.shift + shift;
  scene.camera.position += -shift;
  for (Picture& view : scene.views) view.camera.position += -shift;
  for (Object& object : scene.objects) std::visit([&](auto& shape) { shape.move(-shift); }, object.shape);
  for (Light& light : scene.lights) std::visit(MoveEmitter{-shift}, light.emitter);
}

}  // namespace vitrail
