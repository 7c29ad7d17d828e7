#include "render/first_hit.h"

#include "render/camera.h"

namespace vitrail {

FirstHitFinder::FirstHitFinder(const World& world, const Picture& picture)
    : world_(world), picture_(picture), media_(world.intersector.media_at(picture.camera.position)) {}

FirstHit FirstHitFinder::through(double x, double y) const {
  const Scene& scene = world_.scene;
  const Ray ray = camera_ray(picture_.camera, picture_.image, x, y);
  const bool from_one_place = picture_.camera.kind == CameraKind::perspective;
  const PathState path{.ray = ray,
                       .media = from_one_place ? media_ : world_.intersector.media_at(ray.origin),
                       .ior = scene.paper.disperse_camera ? IorSource::band : IorSource::camera};
  FirstHit found{.arrival = advance(world_, path)};
  if (found.arrival.escaped) return found;
  found.cosine = -dot(ray.direction, found.arrival.event.facing_normal);
  found.ior_ratio = ior_in(scene, path.media, path.band) / found.arrival.event.index.from;
  return found;
}

}  // namespace vitrail
