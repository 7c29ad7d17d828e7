#include "geometry/lens.h"

#include <cmath>

#include "geometry/axial.h"
#include "geometry/round.h"

namespace vitrail {

namespace {

/// Cut a span to the half space out * z <= out * level.
void cut_level(Span& span, const Ray& local, double level, double out, std::uint32_t face, bool on_level) {
  const double climb = out * local.direction.z, height = out * (local.origin.z - level);
  if (climb == 0) {
    if (!on_level && height > 0) span.out = -kInfinity;
    return;
  }
  const double t = on_level ? 0.0 : -height / climb;
  climb > 0 ? span.leave(t, face) : span.enter(t, face);
}

/// The hull of two overlapping pieces of one convex piece.
Span hull(const Span& a, const Span& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  Span both = a;
  if (b.in < both.in) both.in = b.in, both.face_in = b.face_in;
  if (b.out > both.out) both.out = b.out, both.face_out = b.face_out;
  return both;
}

}  // namespace

Lens::Cap Lens::make_cap(double radius, double half_thickness, double half_diameter, double out) {
  Cap cap{radius, out * half_thickness, 0, out * half_thickness, out};
  if (radius == 0) return cap;
  const double r = std::abs(radius);
  const double sag = half_diameter * half_diameter / (r + std::sqrt((r - half_diameter) * (r + half_diameter)));
  cap.center = cap.vertex - out * radius;
  cap.rim = cap.vertex - out * (radius > 0 ? sag : -sag);
  return cap;
}

Lens::Lens(const LensShape& shape)
    : caps_{make_cap(shape.radius_front, shape.thickness / 2, shape.diameter / 2, -1),
            make_cap(shape.radius_back, shape.thickness / 2, shape.diameter / 2, 1)},
      half_diameter_(shape.diameter / 2),
      frame_(shape.frame) {}

bool Lens::cut_convex(Span& span, const Ray& local, const Cap& cap, std::uint32_t face, const Departure* left) const {
  const bool on_face = departs_from(left, face);
  if (cap.radius <= 0) {
    // Flat: the face itself. Concave: the level of its edge, which only bounds what the ball is taken from.
    cut_level(span, local, cap.rim, cap.out, face, on_face && cap.radius == 0);
    return !span.is_empty();
  }

  // Convex: the ball, or anything on the lens side of its centre; both within the rim they make one piece.
  Span in_ball = span, beyond = span;
  double in = 0, out = 0;
  if (ball_span({0, 0, cap.center}, cap.radius, local, on_face, in, out)) {
    in_ball.enter(in, face);
    in_ball.leave(out, face);
  } else {
    in_ball.out = -kInfinity;
  }
  cut_level(beyond, local, cap.center, cap.out, face, false);
  span = hull(in_ball, beyond);
  return !span.is_empty();
}

bool Lens::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  const Ray local{frame_.point_to_local(ray.origin), frame_.direction_to_local(ray.direction)};
  const Vec3 lateral{local.origin.x, local.origin.y, 0}, drift{local.direction.x, local.direction.y, 0};

  // The convex hull of the lens first: rim and the two faces.
  InlineVector<Span, 3> spans;
  Span whole;
  const bool met = cut_wall(whole, lateral, drift, 0, half_diameter_, 0, 2, departs_from(left, 2)) &&
                   cut_convex(whole, local, caps_[0], 0, left) && cut_convex(whole, local, caps_[1], 1, left);
  if (met) spans.push_back(whole);

  // Then take the balls of concave faces out of it; each splits a piece in two at most.
  for (std::uint32_t face = 0; face < 2; ++face) {
    double in = 0, out = 0;
    if (caps_[face].radius >= 0) continue;
    if (!ball_span({0, 0, caps_[face].center}, -caps_[face].radius, local, departs_from(left, face), in, out)) continue;
    InlineVector<Span, 3> rest;
    for (const Span& span : spans) {
      Span before = span, after = span;
      before.leave(in, face);
      after.enter(out, face);
      if (!before.is_empty()) rest.push_back(before);
      if (!after.is_empty()) rest.push_back(after);
    }
    spans = rest;
  }
  return first_event(spans.begin(), spans.end(), left, hit);
}

SurfacePoint Lens::surface(Vec3 point, std::uint32_t face) const {
  Vec3 local = frame_.point_to_local(point), normal;
  if (face == 2) {
    const double distance = std::hypot(local.x, local.y);
    normal = {local.x / distance, local.y / distance, 0};
    local = {normal.x * half_diameter_, normal.y * half_diameter_, local.z};
  } else if (const Cap& cap = caps_[face]; cap.radius == 0) {
    normal = {0, 0, cap.out};
    local.z = cap.vertex;
  } else {
    const Vec3 center{0, 0, cap.center};
    local = project_to_sphere(local, center, std::abs(cap.radius));
    normal = normalise(local - center) * (cap.radius > 0 ? 1.0 : -1.0);
  }
  return {frame_.point_to_world(local), frame_.direction_to_world(normal)};
}

bool Lens::within(const Cap& cap, Vec3 local) {
  const double height = cap.out * (local.z - cap.center);
  if (cap.radius == 0) return cap.out * (local.z - cap.vertex) < 0;
  const double power = power_of_point(local, {0, 0, cap.center}, std::abs(cap.radius));
  return cap.radius > 0 ? height < 0 || power < 0 : height < 0 && power > 0;
}

bool Lens::contains(Vec3 point) const {
  const Vec3 local = frame_.point_to_local(point);
  return std::hypot(local.x, local.y) < half_diameter_ && within(caps_[0], local) && within(caps_[1], local);
}

Bounds Lens::bounds() const {
  Bounds local;
  local.add(Vec3{-half_diameter_, -half_diameter_, std::min(caps_[0].vertex, caps_[0].rim)});
  local.add(Vec3{half_diameter_, half_diameter_, std::max(caps_[1].vertex, caps_[1].rim)});
  return placed(local, frame_);
}

double Lens::coordinate_scale() const {
  const double reach = std::max({half_diameter_, std::abs(caps_[0].center), std::abs(caps_[1].center)});
  return reach + largest_coordinate(frame_.origin);
}

}  // namespace vitrail
