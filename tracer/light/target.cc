#include "light/target.h"

#include <cmath>

namespace vitrail {
namespace {

BoundingSphere sphere_around(const Bounds& box) { return {(box.min + box.max) * 0.5, length(box.max - box.min) * 0.5}; }

Bounds box_around(const BoundingSphere& s) {
  const Vec3 reach{s.radius, s.radius, s.radius};
  return {s.center - reach, s.center + reach};
}

bool is_specular(const Material& material) {
  return !is_black(material.reflection) || !is_black(material.transmission);
}

// Cover what a plane mirrors into the finite part of the scene: the image of that part is as far behind as it is in
// front.
Target target_of_plane(std::uint32_t object, const PlaneShape& plane, const BoundingSphere& surroundings) {
  const double height = dot(surroundings.center - plane.point, plane.normal);
  const BoundingSphere bound{surroundings.center - plane.normal * height, std::abs(height) + surroundings.radius};
  return {object, bound, box_around(bound)};
}

}  // namespace

std::vector<PlaneShape> planes_of(const Scene& scene) {
  std::vector<PlaneShape> planes;
  for (const Object& object : scene.objects) {
    if (const auto* plane = std::get_if<PlaneShape>(&object.shape)) planes.push_back(*plane);
  }
  return planes;
}

Targets find_targets(const Scene& scene, const Intersector& intersector) {
  Targets found;
  const Bounds finite = intersector.bounds();
  found.surroundings = {finite.is_empty() ? BoundingSphere{} : sphere_around(finite), planes_of(scene)};
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (!is_specular(scene.material_of(i))) continue;
    if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
      const BoundingSphere bound{sphere->center, sphere->radius};
      found.targets.push_back({i, bound, box_around(bound)});
    } else if (const auto* plane = std::get_if<PlaneShape>(&object.shape)) {
      if (finite.is_empty()) continue;
      found.targets.push_back(target_of_plane(i, *plane, found.surroundings));
      found.warnings.push_back("objects." + object.name + ": photons cover this infinite plane only within " +
                               std::to_string(found.targets.back().bound.radius) +
                               " m of the finite objects; use a rectangle to cover a chosen part");
    } else {
      const Bounds box = intersector.object_bounds(i);
      found.targets.push_back({i, sphere_around(box), box});
    }
  }
  return found;
}

}  // namespace vitrail
