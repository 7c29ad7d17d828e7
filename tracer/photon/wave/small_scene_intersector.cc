#include "photon/wave/small_scene_intersector.h"

namespace vitrail {
namespace {

// Any other shape answers ray by ray.
void intersect_one_by_one(const Primitive& primitive, std::int32_t object, RayChunk& rays) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
    const Ray ray{{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]},
                  {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]}};
    const HitId departed = HitId::of_lane(rays.departed[i]);
    const Departure departure{static_cast<std::uint32_t>(object),
                              static_cast<std::uint32_t>(rays.states[i].departed_face), departed.entering};
    ShapeHit hit;
    if (!intersect(primitive, ray, departed.object == object ? &departure : nullptr, hit)) continue;
    if (hit.t < rays.nearest[i]) {
      rays.next[i] = rays.nearest[i];
      rays.nearest[i] = hit.t;
      rays.met[i] = HitId{object, hit.entering}.lane();
      rays.met_face[i] = static_cast<std::int32_t>(hit.face);
    } else if (hit.t < rays.next[i]) {
      rays.next[i] = hit.t;
    }
  }
}

bool has_lanes(const Shape& shape) {
  return std::holds_alternative<SphereShape>(shape) || std::holds_alternative<PlaneShape>(shape) ||
         std::holds_alternative<RectangleShape>(shape) || std::holds_alternative<DiscShape>(shape);
}

}  // namespace

bool SmallSceneIntersector::suits(const Scene& scene) {
  std::size_t others = 0;
  for (const Object& object : scene.objects) {
    if (std::holds_alternative<MeshShape>(object.shape)) return false;
    others += has_lanes(object.shape) ? 0 : 1;
  }
  return scene.objects.size() <= kMost && others <= kMostOthers;
}

SmallSceneIntersector::SmallSceneIntersector(const Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Shape& shape = scene.objects[i].shape;
    items_.push_back({static_cast<std::int32_t>(i), shape, make_primitive(shape)});
  }
}

void SmallSceneIntersector::find(RayChunk& rays) const {
  rays.nearest.fill(kInfinity);
  rays.next.fill(kInfinity);
  rays.met.fill(kNoObject);
  rays.met_face.fill(0);
  for (const Item& item : items_) {
    if (const auto* sphere = std::get_if<SphereShape>(&item.shape)) {
      intersect(*sphere, item.object, rays);
    } else if (const auto* plane = std::get_if<PlaneShape>(&item.shape)) {
      intersect(*plane, item.object, rays);
    } else if (const auto* rectangle = std::get_if<RectangleShape>(&item.shape)) {
      intersect(*rectangle, item.object, rays);
    } else if (const auto* disc = std::get_if<DiscShape>(&item.shape)) {
      intersect(*disc, item.object, rays);
    } else {
      intersect_one_by_one(item.primitive, item.object, rays);
    }
  }
  find_ties(rays);
}

void SmallSceneIntersector::settle(std::uint32_t object, const std::int32_t* faces, int count,
                                   SurfaceLanes& lanes) const {
  const Item& item = items_[object];
  if (const auto* sphere = std::get_if<SphereShape>(&item.shape)) {
    project(*sphere, count, lanes);
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const SurfacePoint at = surface(item.primitive, {lanes.point[0][i], lanes.point[1][i], lanes.point[2][i]},
                                    static_cast<std::uint32_t>(faces[i]));
    for (int a = 0; a < 3; ++a) {
      lanes.point[a][i] = at.point[a];
      lanes.normal[a][i] = at.normal[a];
    }
  }
}

}  // namespace vitrail
