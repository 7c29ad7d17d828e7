#include "geometry/sphere.h"

#include "geometry/round.h"

namespace vitrail {

bool Sphere::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  // Turn away from balls behind without any root: nothing of theirs can lie ahead.
  if (left != nullptr && !left->inside) return false;
  Span span;
  if (!ball_span(center_, radius_, ray, left != nullptr, span.in, span.out)) return false;
  return first_event(span, left, hit);
}

SurfacePoint Sphere::surface(Vec3 point, std::uint32_t) const {
  const Vec3 on_sphere = project_to_sphere(point, center_, radius_);
  return {on_sphere, normalise(on_sphere - center_)};
}

bool Sphere::contains(Vec3 point) const { return power_of_point(point, center_, radius_) < 0; }

Bounds Sphere::bounds() const {
  const Vec3 reach{radius_, radius_, radius_};
  return {center_ - reach, center_ + reach};
}

}  // namespace vitrail
