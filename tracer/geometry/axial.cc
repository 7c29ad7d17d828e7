#include "geometry/axial.h"

#include <cmath>
#include <tuple>

#include "geometry/box.h"
#include "geometry/round.h"

namespace vitrail {

namespace {

/// Where |o + t d| <= rho + t rise: a t^2 - 2 b t + c <= 0 in the variables of stable_roots.
struct WallEquation {
  double a = 0, b = 0, c = 0, root = 0;
  bool real = false;
};

WallEquation wall_equation(Vec3 o, Vec3 d, double rho, double rise, bool on_wall) {
  WallEquation eq;
  eq.a = length_squared(d) - rise * rise;
  eq.b = rho * rise - dot(o, d);
  const double distance = length(o);
  eq.c = on_wall ? 0.0 : (distance - rho) * (distance + rho);

  // A straight wall is decided by the closest approach to the axis, which keeps its digits from afar.
  double discriminant = eq.b * eq.b - eq.a * eq.c;
  if (rise == 0 && eq.a > 0 && !on_wall) {
    const double closest = length(o + d * (eq.b / eq.a));
    discriminant = eq.a * (rho - closest) * (rho + closest);
  }
  eq.real = discriminant >= 0;
  eq.root = eq.real ? std::sqrt(discriminant) : 0;
  return eq;
}

}  // namespace

bool cut_wall(Span& span, Vec3 lateral_origin, Vec3 lateral_direction, double climb, double radius, double slope,
              std::uint32_t face, bool on_wall) {
  const double rise = slope * climb;

  // From afar, solve about the closest approach to the axis: the squares of the way there would drown the radius.
  const double pace = length_squared(lateral_direction);
  if (rise != 0 && !on_wall && pace > 0) {
    const double ahead = -dot(lateral_origin, lateral_direction) / pace;
    const Vec3 nearest = lateral_origin + lateral_direction * ahead;
    const double radius_there = radius + rise * ahead;
    if (length_squared(lateral_origin) > 64 * (length_squared(nearest) + radius_there * radius_there)) {
      Span there{span.in - ahead, span.out - ahead, span.face_in, span.face_out};
      if (!cut_wall(there, nearest, lateral_direction, climb, radius_there, slope, face, false)) return false;
      span = {there.in + ahead, there.out + ahead, there.face_in, there.face_out};
      return true;
    }
  }
  const WallEquation eq = wall_equation(lateral_origin, lateral_direction, radius, rise, on_wall);

  // Parallel to the wall all the way: in or out as the origin is; parallel to one side line of a cone: one crossing.
  if (eq.a == 0) {
    if (eq.b == 0) return on_wall || eq.c < 0;
    const double t = eq.c / (2 * eq.b);
    eq.b > 0 ? span.enter(t, face) : span.leave(t, face);
    return true;
  }
  if (!eq.real) return false;

  double first = 0, second = 0;
  if (eq.a > 0) {
    std::tie(first, second) = stable_roots(eq.a, eq.b, eq.c, eq.root);
    span.leave(second, face);
    span.enter(first, face);
    return true;
  }

  // Steeper than the wall: inside beyond one crossing, the one on the half of the double cone that has a radius.
  const double q = eq.b >= 0 ? eq.b + eq.root : eq.b - eq.root;
  const double one = q == 0 ? 0 : eq.c / q, other = q == 0 ? 0 : q / eq.a;
  rise > 0 ? span.enter(std::max(one, other), face) : span.leave(std::min(one, other), face);
  return true;
}

Axial::Axial(Vec3 from, Vec3 to, double radius_from, double radius_to)
    : from_(from),
      axis_(normalise(to - from)),
      length_(length(to - from)),
      radius_from_(radius_from),
      radius_to_(radius_to),
      slope_((radius_to - radius_from) / length_) {}

bool Axial::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  if (left != nullptr && !left->inside) return false;
  const Vec3 offset = ray.origin - from_;
  const double height = dot(offset, axis_), climb = dot(ray.direction, axis_);
  const Vec3 lateral = offset - axis_ * height, drift = ray.direction - axis_ * climb;

  // A line that misses the wall of a solid it is in grazes the face it stands on: leave there and then.
  Span span;
  const bool met =
      cut_wall(span, lateral, drift, climb, radius_from_ + slope_ * height, slope_, 0, departs_from(left, 0)) &&
      cut_slab(span, height, climb, 0, length_, 1, 2, left);
  if (!met && left == nullptr) return false;
  if (!met) {
    hit = {0, left->face, false};
    return true;
  }
  return first_event(span, left, hit);
}

SurfacePoint Axial::surface(Vec3 point, std::uint32_t face) const {
  const Vec3 offset = point - from_;
  const double height = dot(offset, axis_);
  if (face == 1) return {point - axis_ * height, -axis_};
  if (face == 2) return {point - axis_ * (height - length_), axis_};

  // Move along the slanted normal until the distance to the axis is the radius there.
  const Vec3 lateral = offset - axis_ * height;
  const double distance = length(lateral);
  const Vec3 outward = distance > 0 ? lateral / distance : surface_frame(axis_).u;
  const Vec3 normal = normalise(outward - axis_ * slope_);
  const double gap = (distance - (radius_from_ + slope_ * height)) / std::sqrt(1 + slope_ * slope_);
  return {point - normal * gap, normal};
}

bool Axial::contains(Vec3 point) const {
  const Vec3 offset = point - from_;
  const double height = dot(offset, axis_);
  return 0 < height && height < length_ && length(offset - axis_ * height) < radius_from_ + slope_ * height;
}

Bounds Axial::bounds() const {
  const auto reach = [](double n, double radius) { return radius * std::sqrt(std::max(0.0, (1 - n) * (1 + n))); };
  Bounds box;
  for (const auto& [center, radius] : {std::pair{from_, radius_from_}, {from_ + axis_ * length_, radius_to_}}) {
    const Vec3 extent{reach(axis_.x, radius), reach(axis_.y, radius), reach(axis_.z, radius)};
    box.add(center - extent);
    box.add(center + extent);
  }
  return box;
}

double Axial::coordinate_scale() const {
  return largest_coordinate(from_) + length_ + std::max(radius_from_, radius_to_);
}

}  // namespace vitrail
