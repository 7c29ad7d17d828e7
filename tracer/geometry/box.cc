#include "geometry/box.h"

#include <cmath>

namespace vitrail {

bool cut_slab(Span& span, double origin, double direction, double low, double high, std::uint32_t face_low,
              std::uint32_t face_high, const Departure* left) {
  const bool from_low = departs_from(left, face_low), from_high = departs_from(left, face_high);
  if (direction == 0) return left != nullptr || (low < origin && origin < high);
  const double t_low = (low - origin) / direction, t_high = (high - origin) / direction;

  // The face that is left bounds nothing: a ray inside goes out by another one.
  const bool upward = direction > 0;
  if (upward ? !from_low : !from_high) span.enter(upward ? t_low : t_high, upward ? face_low : face_high);
  if (upward ? !from_high : !from_low) span.leave(upward ? t_high : t_low, upward ? face_high : face_low);
  return true;
}

Box::Box(const BoxShape& shape) : min_(shape.min), max_(shape.max), frame_(shape.frame) {
  // Without a rotation, stand in the world; with one, stand around the origin of the frame.
  if (frame_.identity) {
    min_ = min_ + frame_.origin;
    max_ = max_ + frame_.origin;
    frame_.origin = {};
  } else {
    const Vec3 middle = (min_ + max_) * 0.5, half = (max_ - min_) * 0.5;
    frame_.origin = frame_.point_to_world(middle);
    min_ = -half;
    max_ = half;
  }
}

bool Box::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  if (left != nullptr && !left->inside) return false;
  const Vec3 origin = frame_.point_to_local(ray.origin);
  const Vec3 direction = frame_.direction_to_local(ray.direction);
  Span span;
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    if (!cut_slab(span, origin[axis], direction[axis], min_[axis], max_[axis], 2 * axis, 2 * axis + 1, left))
      return false;
  return first_event(span, left, hit);
}

SurfacePoint Box::surface(Vec3 point, std::uint32_t face) const {
  const int axis = static_cast<int>(face / 2);
  const bool upper = face % 2 == 1;
  Vec3 local = frame_.point_to_local(point), normal;
  local[axis] = upper ? max_[axis] : min_[axis];
  normal[axis] = upper ? 1 : -1;
  return {frame_.point_to_world(local), frame_.direction_to_world(normal)};
}

bool Box::contains(Vec3 point) const {
  const Vec3 local = frame_.point_to_local(point);
  return min_.x < local.x && local.x < max_.x && min_.y < local.y && local.y < max_.y && min_.z < local.z &&
         local.z < max_.z;
}

double Box::coordinate_scale() const {
  const double corner = std::max(largest_coordinate(min_), largest_coordinate(max_));
  return frame_.identity ? corner : corner + largest_coordinate(frame_.origin);
}

}  // namespace vitrail
