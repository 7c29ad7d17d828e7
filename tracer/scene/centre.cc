#include "scene/centre.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vitrail {

namespace {

/// Where a shape is and how large, roughly; nothing for shapes without an end.
struct Place {
  Vec3 centre;
  double size = 0;
};

Place place_between(Vec3 a, Vec3 b, double margin) {
  return {(a + b) * 0.5, std::max(largest_coordinate(b - a), margin)};
}

struct PlaceOf {
  std::optional<Place> operator()(const SphereShape& s) const { return Place{s.center, s.radius}; }
  std::optional<Place> operator()(const PlaneShape&) const { return {}; }
  std::optional<Place> operator()(const RectangleShape& s) const {
    return Place{s.center, std::max(largest_coordinate(s.u), largest_coordinate(s.v))};
  }
  std::optional<Place> operator()(const DiscShape& s) const { return Place{s.center, s.radius}; }
  std::optional<Place> operator()(const BoxShape& s) const {
    return Place{s.frame.point_to_world((s.min + s.max) * 0.5), largest_coordinate(s.max - s.min)};
  }
  std::optional<Place> operator()(const CylinderShape& s) const { return place_between(s.from, s.to, s.radius); }
  std::optional<Place> operator()(const ConeShape& s) const {
    return place_between(s.from, s.to, std::max(s.radius_from, s.radius_to));
  }
  std::optional<Place> operator()(const PrismShape& s) const { return Place{s.frame.origin, s.height}; }
  std::optional<Place> operator()(const LensShape& s) const { return Place{s.frame.origin, s.diameter}; }
  std::optional<Place> operator()(const MeshShape&) const { return {}; }  // its file is not read here
};

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

void move(Vec3& point, Vec3 shift) { point = point - shift; }

struct MoveShape {
  Vec3 shift;
  void operator()(SphereShape& s) const { move(s.center, shift); }
  void operator()(PlaneShape& s) const { move(s.point, shift); }
  void operator()(RectangleShape& s) const { move(s.center, shift); }
  void operator()(DiscShape& s) const { move(s.center, shift); }
  void operator()(BoxShape& s) const { move(s.frame.origin, shift); }
  void operator()(CylinderShape& s) const { move(s.from, shift), move(s.to, shift); }
  void operator()(ConeShape& s) const { move(s.from, shift), move(s.to, shift); }
  void operator()(PrismShape& s) const { move(s.frame.origin, shift); }
  void operator()(LensShape& s) const { move(s.frame.origin, shift); }
  void operator()(MeshShape& s) const { move(s.frame.origin, shift); }
};

struct MoveEmitter {
  Vec3 shift;
  void operator()(DirectionalLight&) const {}
  void operator()(PointLight& l) const { move(l.position, shift); }
  void operator()(SpotLight& l) const { move(l.position, shift); }
  void operator()(AreaLight& l) const {
    std::visit([&](auto& shape) { move(shape.center, shift); }, l.shape);
  }
  void operator()(EnvironmentLight&) const {}
};

}  // namespace

void centre_scene(Scene& scene) {
  std::vector<Place> places;
  for (const Object& object : scene.objects)
    if (const std::optional<Place> place = std::visit(PlaceOf{}, object.shape)) places.push_back(*place);
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
  move(scene.camera.position, shift);
  for (Object& object : scene.objects) std::visit(MoveShape{shift}, object.shape);
  for (Light& light : scene.lights) std::visit(MoveEmitter{shift}, light.emitter);
}

}  // namespace vitrail
