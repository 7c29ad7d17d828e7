#include "geometry/prism.h"

#include <cmath>

#include "geometry/box.h"

namespace vitrail {

Prism::Prism(const PrismShape& shape) : half_height_(shape.height / 2), frame_(shape.frame) {
  for (const auto& corner : shape.corners) corners_.push_back({corner[0], corner[1]});
}

void Prism::outline_cuts(const Ray& local, const Departure* left, std::vector<Cut>& cuts) const {
  // The side of the line on which a corner lies is computed once a corner: neighbouring sides agree on it, so that a
  // line through a corner crosses both sides, one of them, or none, but always an even number in all.
  const double dx = local.direction.x, dy = local.direction.y;
  const auto side_of_line = [&](const Corner& c) { return dx * (c.y - local.origin.y) - dy * (c.x - local.origin.x); };
  const auto count = static_cast<std::uint32_t>(corners_.size());
  double before = side_of_line(corners_[0]);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Corner &a = corners_[i], &b = corners_[i + 1 < count ? i + 1 : 0];
    const double after = side_of_line(b);
    if ((before > 0) != (after > 0)) {
      const double ex = b.x - a.x, ey = b.y - a.y;
      const double t = ((a.x - local.origin.x) * ey - (a.y - local.origin.y) * ex) / (dx * ey - dy * ex);
      cuts.push_back({departs_from(left, i) ? 0.0 : t, i});
    }
    before = after;
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& x, const Cut& y) { return x.t < y.t; });
}

bool Prism::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  const Ray local{frame_.point_to_local(ray.origin), frame_.direction_to_local(ray.direction)};
  const auto lower = static_cast<std::uint32_t>(corners_.size());
  thread_local std::vector<Cut> cuts;
  thread_local std::vector<Span> spans;
  cuts.clear();
  spans.clear();

  // Between the two ends ...
  Span between_ends;
  const bool outside = left != nullptr && !left->inside;
  if (outside && left->face >= lower) return false;
  if (!cut_slab(between_ends, local.origin.z, local.direction.z, -half_height_, half_height_, lower, lower + 1, left))
    return false;

  // ... take the pieces inside the outline; along z it is all or nothing.
  if (local.direction.x == 0 && local.direction.y == 0) {
    if (left != nullptr || polygon_contains(local.origin.x, local.origin.y)) spans.push_back(between_ends);
  } else {
    outline_cuts(local, left, cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
      Span span = between_ends;
      span.enter(cuts[i].t, cuts[i].face);
      span.leave(cuts[i + 1].t, cuts[i + 1].face);
      if (!span.is_empty()) spans.push_back(span);
    }
  }
  return first_event(spans.data(), spans.data() + spans.size(), left, hit);
}

SurfacePoint Prism::surface(Vec3 point, std::uint32_t face) const {
  Vec3 local = frame_.point_to_local(point), normal;
  const auto lower = static_cast<std::uint32_t>(corners_.size());
  if (face >= lower) {
    normal.z = face == lower ? -1 : 1;
    local.z = normal.z * half_height_;
  } else {
    // The outline is counter-clockwise: outward is to the right of a side.
    const Corner &a = corners_[face], &b = corners_[face + 1 < lower ? face + 1 : 0];
    normal = normalise({b.y - a.y, a.x - b.x, 0});
    local = local - normal * ((local.x - a.x) * normal.x + (local.y - a.y) * normal.y);
  }
  return {frame_.point_to_world(local), frame_.direction_to_world(normal)};
}

bool Prism::polygon_contains(double x, double y) const {
  // Count crossings to the right, each side half open so that a corner counts once.
  bool inside = false;
  for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
    const Corner &a = corners_[j], &b = corners_[i];
    if ((a.y > y) == (b.y > y)) continue;
    const double turn = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    if (b.y > a.y ? turn > 0 : turn < 0) inside = !inside;
  }
  return inside;
}

bool Prism::contains(Vec3 point) const {
  const Vec3 local = frame_.point_to_local(point);
  return std::abs(local.z) < half_height_ && polygon_contains(local.x, local.y);
}

Bounds Prism::bounds() const {
  Bounds local;
  for (const Corner& c : corners_) {
    local.add(Vec3{c.x, c.y, -half_height_});
    local.add(Vec3{c.x, c.y, half_height_});
  }
  return placed(local, frame_);
}

double Prism::coordinate_scale() const {
  double reach = half_height_;
  for (const Corner& c : corners_) reach = std::max({reach, std::abs(c.x), std::abs(c.y)});
  return reach + largest_coordinate(frame_.origin);
}

}  // namespace vitrail
