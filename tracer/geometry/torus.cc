#include "geometry/torus.h"

#include <algorithm>
#include <cmath>

#include "geometry/axis_line.h"

namespace vitrail {

namespace {

/// A value and its derivative along the line.
struct Slope {
  double value = 0, rate = 0;
};

/// The root of a function that changes sign once in [low, high]: Newton's steps, halving where they do not at least
/// halve. `rising`: it is below zero at `low`. Ends when a step is below `resolution`.
template <typename Function>
double root_between(const Function& function, double low, double high, double guess, bool rising, double resolution) {
  double t = guess > low && guess < high ? guess : low + (high - low) / 2, last_step = high - low;
  for (int i = 0; i < 200; ++i) {
    const auto [value, rate] = function(t);
    if (value == 0) return t;
    ((value < 0) == rising ? low : high) = t;
    double next = t - value / rate;
    if (!(next > low && next < high) || std::abs(next - t) > last_step / 2) next = low + (high - low) / 2;
    last_step = std::abs(next - t);
    t = next;
    if (last_step <= resolution) break;
  }
  return t;
}

/// The squared distance q of a line from the ring, and where it falls and rises.
class RingDistance {
 public:
  RingDistance(const AxisLine& line, double ring, double low, double high)
      : line_(line), ring_(ring), resolution_(0x1p-54 * ring) {
    find_turns(low, high);
  }

  /// q and dq/dt.
  Slope squared(double t) const {
    const double from_ring = line_.radius_at(t) - ring_, height = line_.height_at(t);
    return {from_ring * from_ring + height * height, 2 * half_rate(t).value};
  }
  /// The spans where q is below `limit`. With `on_surface`, q is `limit` at t = 0, exactly.
  InlineVector<Span, 2> spans_below(double limit, bool on_surface) const;

 private:
  /// half dq/dt at a given distance from the axis, of given rate.
  double half_rate(double t, double radius, double radius_rate) const {
    return (radius - ring_) * radius_rate + line_.height_at(t) * line_.climb;
  }
  /// half dq/dt and its derivative 1 - R pace^2 miss^2 / rho^3.
  Slope half_rate(double t) const {
    const double radius = line_.radius_at(t);
    if (radius == 0) return {half_rate(t, 0, 0), 1};
    const double part = line_.miss / radius;
    return {half_rate(t, radius, line_.pace * line_.across_at(t) / radius),
            1 - ring_ * line_.pace * line_.pace * part * part / radius};
  }
  double turn_between(double low, double high, bool rising) const {
    return root_between([&](double t) { return half_rate(t); }, low, high, low + (high - low) / 2, rising, resolution_);
  }
  void find_turns(double low, double high);
  double crossing(double low, double high, double minimum, double limit, bool rising, bool on_surface) const;

  AxisLine line_;
  double ring_, resolution_;
  double low_ = 0, high_ = 0;
  InlineVector<double, 3> turns_;  // a minimum, or minimum, maximum, minimum
};

void RingDistance::find_turns(double low, double high) {
  low_ = low;
  high_ = high;
  // q'' = 2 - 2 R pace^2 miss^2 / rho^3: convex everywhere unless the line passes close to the axis.
  const double reach = ring_ * line_.pace * line_.pace;
  if (!(reach > line_.miss)) {
    turns_.push_back(turn_between(low, high, true));
    return;
  }

  // Between the two points of inflection, at rho^3 = R pace^2 miss^2, q is concave; its rate is largest at the first
  // and least at the second. On a line through the axis both are one kink, whose two rates follow from the same
  // formula.
  const double part = std::cbrt(line_.miss / reach);
  const double radius = line_.miss > 0 ? line_.miss / part : 0;
  const double share = std::sqrt((1 - part) * (1 + part));
  const double first = (-radius * share - line_.across) / line_.pace;
  const double second = (radius * share - line_.across) / line_.pace;
  const double rate = line_.pace * share;
  const bool falls_before = first > low && half_rate(first, radius, -rate) > 0;
  const bool rises_after = second < high && half_rate(second, radius, rate) < 0;
  if (falls_before) turns_.push_back(turn_between(low, first, true));
  if (falls_before && rises_after) turns_.push_back(turn_between(first, second, false));
  if (rises_after) turns_.push_back(turn_between(second, high, true));
}

double RingDistance::crossing(double low, double high, double minimum, double limit, bool rising,
                              bool on_surface) const {
  if (on_surface && low <= 0 && 0 <= high) return 0;
  // Begin where a parabola with the depth and the curvature at the minimum reaches the limit.
  const double depth = limit - squared(minimum).value, curvature = half_rate(minimum).rate;
  const double reach = curvature > 0 ? std::sqrt(depth / curvature) : 0;
  const auto excess = [&](double t) {
    const Slope at = squared(t);
    return Slope{at.value - limit, at.rate};
  };
  return root_between(excess, low, high, rising ? minimum + reach : minimum - reach, rising, resolution_);
}

InlineVector<Span, 2> RingDistance::spans_below(double limit, bool on_surface) const {
  InlineVector<Span, 2> spans;
  const auto is_below = [&](int turn) { return squared(turns_[turn]).value < limit; };
  const auto add = [&](int first, int last, double low, double high) {
    Span span;
    span.in = crossing(low, turns_[first], turns_[first], limit, false, on_surface);
    span.out = crossing(turns_[last], high, turns_[last], limit, true, on_surface);
    spans.push_back(span);
  };

  // One piece from the first minimum to the last, if the maximum between them stays below too; else one a minimum.
  const int last = turns_.size() - 1;
  if (last == 2 && is_below(1)) {
    add(0, 2, low_, high_);
    return spans;
  }
  for (int minimum = 0; minimum <= last; minimum += 2)
    if (is_below(minimum)) add(minimum, minimum, minimum == 0 ? low_ : turns_[1], minimum == last ? high_ : turns_[1]);
  return spans;
}

}  // namespace

bool Torus::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  // Solve about the point of the line next to the centre, but a ray that stands on the surface about its origin.
  Vec3 offset = ray.origin - center_;
  const double middle = -dot(offset, ray.direction);
  const double ahead = left == nullptr ? middle : 0;
  offset = offset + ray.direction * ahead;
  const double reach = ring_ + tube_;
  if (left == nullptr && length_squared(offset) > reach * reach) return false;

  // Beyond the ball around the torus no root is left: 1 % more than its radius leaves room for any rounding.
  const AxisLine line(offset, ray.direction, axis_);
  const RingDistance distance(line, ring_, middle - ahead - 1.01 * reach, middle - ahead + 1.01 * reach);
  const double limit = left == nullptr ? tube_ * tube_ : distance.squared(0).value;
  InlineVector<Span, 2> spans = distance.spans_below(limit, left != nullptr);
  for (Span& span : spans) span.in += ahead, span.out += ahead;
  return first_event(spans.begin(), spans.end(), left, hit);
}

SurfacePoint Torus::surface(Vec3 point, std::uint32_t) const {
  const Vec3 offset = point - center_;
  const double height = dot(offset, axis_);
  const Vec3 lateral = offset - axis_ * height;
  const double radius = length(lateral);
  const Vec3 outward = radius > 0 ? lateral / radius : Vec3{};
  const Vec3 normal = normalise(outward * (radius - ring_) + axis_ * height);
  return {center_ + outward * ring_ + normal * tube_, normal};
}

bool Torus::contains(Vec3 point) const {
  const Vec3 offset = point - center_;
  const double height = dot(offset, axis_), from_ring = length(offset - axis_ * height) - ring_;
  return from_ring * from_ring + height * height < tube_ * tube_;
}

Bounds Torus::bounds() const {
  const auto reach = [&](double n) { return ring_ * std::sqrt(std::max(0.0, (1 - n) * (1 + n))) + tube_; };
  const Vec3 extent{reach(axis_.x), reach(axis_.y), reach(axis_.z)};
  return {center_ - extent, center_ + extent};
}

double Torus::coordinate_scale() const { return largest_coordinate(center_) + ring_ + tube_; }

}  // namespace vitrail
