#include "geometry/flat.h"

#include <cmath>

namespace vitrail {

bool Flat::distance(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  if (left != nullptr) return false;
  const double height = dot(ray.origin - point_, normal_);
  const double climb = dot(ray.direction, normal_);
  const double t = -height / climb;
  if (!(t > 0) || std::isinf(t)) return false;
  hit = {t, 0, climb < 0};
  return true;
}

SurfacePoint Flat::surface(Vec3 point, std::uint32_t) const {
  const Vec3 on_plane = point - normal_ * dot(point - point_, normal_);
  const Vec3 offset = on_plane - point_;
  return {on_plane, normal_, dot(offset, axes_.u), dot(offset, axes_.v)};
}

Rectangle::Rectangle(const RectangleShape& shape)
    : Flat(shape.center, normalise(cross(shape.u, shape.v)), {normalise(shape.u), normalise(shape.v)}),
      half_u_(length(shape.u)),
      half_v_(length(shape.v)) {}

bool Rectangle::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  if (!distance(ray, left, hit)) return false;
  const Vec3 offset = ray.at(hit.t) - point_;
  return std::abs(dot(offset, axes_.u)) <= half_u_ && std::abs(dot(offset, axes_.v)) <= half_v_;
}

Bounds Rectangle::bounds() const {
  const Vec3 u = axes_.u * half_u_, v = axes_.v * half_v_;
  Bounds box;
  for (const Vec3 corner : {u + v, u - v, v - u, -u - v}) box.add(point_ + corner);
  return box;
}

bool Disc::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  return distance(ray, left, hit) && length(ray.at(hit.t) - point_) <= radius_;
}

Bounds Disc::bounds() const {
  // A disc reaches r sqrt(1 - n_i^2) along axis i.
  const auto reach = [&](double n) { return radius_ * std::sqrt(std::max(0.0, (1 - n) * (1 + n))); };
  const Vec3 extent{reach(normal_.x), reach(normal_.y), reach(normal_.z)};
  return {point_ - extent, point_ + extent};
}

}  // namespace vitrail
