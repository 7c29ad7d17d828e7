#include "geometry/lathe.h"

#include <algorithm>
#include <cmath>

#include "geometry/round.h"

namespace vitrail {

namespace {

/// A line against the double cone of a piece: A t^2 - 2 B t + C below zero within it, h = sqrt(B^2 - A C).
struct ConeEquation {
  double a = 0, b = 0, c = 0, h_squared = 0;
};

/// `reach` is rise * (radius of the cone) at the origin of the line, `spread` its change per height, times rise. The
/// discriminant is taken about the point next to the axis, where nothing cancels: rise^2 (J^2 - A miss^2).
ConeEquation cone_equation(const AxisLine& line, double reach, double spread, double rise) {
  const double widening = spread * line.climb, pace = rise * line.pace;
  const double far = rise * line.radius_at(0);
  ConeEquation eq;
  eq.a = (pace - widening) * (pace + widening);
  eq.b = reach * widening - pace * rise * line.across;
  eq.c = (far - reach) * (far + reach);
  const double at_axis = line.pace * reach - widening * line.across;
  eq.h_squared = rise * rise *
                 (eq.a > 0 ? (at_axis - std::sqrt(eq.a) * line.miss) * (at_axis + std::sqrt(eq.a) * line.miss)
                           : at_axis * at_axis - eq.a * line.miss * line.miss);
  return eq;
}

}  // namespace

Lathe::Lathe(const LatheShape& shape) : axis_(shape.frame.direction_to_world({0, 1, 0})) {
  double low = shape.profile[0][1], high = low, turn = 0;
  for (const auto& [radius, height] : shape.profile) {
    low = std::min(low, height);
    high = std::max(high, height);
  }

  // Measure heights from the middle, so that a lathe far up its own axis keeps its digits.
  const double middle = low + (high - low) / 2;
  middle_ = shape.frame.point_to_world({0, middle, 0});
  for (const auto& [radius, height] : shape.profile) {
    corners_.push_back({radius, height - middle});
    reach_ = std::max(reach_, std::sqrt(radius * radius + (height - middle) * (height - middle)));
  }

  // The solid lies on the left of a polygon that runs counter-clockwise, on the right of any other.
  for (std::size_t i = 0; i < corners_.size(); ++i)
    turn += corners_[i].radius * after(i).height - after(i).radius * corners_[i].height;
  for (std::size_t i = 0; i < corners_.size(); ++i) pieces_.push_back(make_piece(corners_[i], after(i), turn));
  add_run(0, static_cast<std::uint32_t>(pieces_.size()));
}

void Lathe::add_run(std::uint32_t first, std::uint32_t end) {
  constexpr std::uint32_t kFew = 8;  // pieces that are looked at one after the other
  Run run{first, end, 0, end - first <= kFew, corners_[first].height, corners_[first].height};
  run.least_squared = run.most_squared = corners_[first].radius * corners_[first].radius;
  for (std::uint32_t i = first; i < end; ++i) {
    const auto [radius, height] = after(i);
    run.low = std::min(run.low, height);
    run.high = std::max(run.high, height);
    run.least_squared = std::min(run.least_squared, radius * radius);
    run.most_squared = std::max(run.most_squared, radius * radius);
  }
  const std::size_t place = runs_.size();
  runs_.push_back(run);
  if (!run.whole) {
    const std::uint32_t middle = first + (end - first) / 2;
    add_run(first, middle);
    add_run(middle, end);
  }
  runs_[place].next = static_cast<std::uint32_t>(runs_.size());
}

// Whether find_cuts would find nothing among the pieces of a run: the line passes inside the circles of all corners, or
// beside all of them and out of reach. Every step from a height to the line's place there keeps order, also rounded, so
// that the corners between the ends of the run do as the ends say.
bool Lathe::passes_by(const AxisLine& line, const Run& run) const {
  if (line.climb == 0) return false;
  const double missed = line.miss * line.miss;
  const double a = line.across_at((run.low - line.height) / line.climb);
  const double b = line.across_at((run.high - line.height) / line.climb);
  const double farthest = std::max(std::abs(a), std::abs(b));
  if (farthest * farthest + missed <= run.least_squared && run.least_squared > 0) return true;
  const double nearest = (a < 0) == (b < 0) ? std::min(std::abs(a), std::abs(b)) : 0;
  return nearest * nearest + missed > run.most_squared;
}

Lathe::Piece Lathe::make_piece(const Corner& a, const Corner& b, double turn) const {
  const double wide = b.radius - a.radius, high = b.height - a.height;
  const double size = std::sqrt(wide * wide + high * high), out = turn > 0 ? 1 : -1, up = high < 0 ? -1 : 1;
  Piece piece;
  piece.spread = up * wide / size;
  piece.rise = up * high / size;
  piece.out_radius = out * high / size;
  piece.out_height = -out * wide / size;
  piece.on_axis = a.radius == 0 && b.radius == 0;
  return piece;
}

void Lathe::cut_piece(const AxisLine& line, std::uint32_t face, bool starts_outside, bool ends_outside, bool on_piece,
                      std::vector<Cut>& cuts) const {
  const Corner &a = corners_[face], &b = after(face);
  const Piece& piece = pieces_[face];
  const bool crossed = starts_outside != ends_outside;
  if (!crossed && !(starts_outside && ends_outside)) return;

  // A flat ring is crossed at its height, or not at all.
  if (piece.rise == 0) {
    if (crossed) cuts.push_back({on_piece ? 0.0 : (a.height - line.height) / line.climb, face});
    return;
  }
  const double reach = piece.rise * a.radius + piece.spread * (line.height - a.height);
  ConeEquation eq = cone_equation(line, reach, piece.spread, piece.rise);
  if (on_piece) eq.c = 0, eq.h_squared = eq.b * eq.b;

  // Outside at both ends: the distance from the axis is convex along the line, so that it dips in twice or never.
  const double at_a = (a.height - line.height) / line.climb, at_b = (b.height - line.height) / line.climb;
  const auto [low, high] = std::minmax(at_a, at_b);
  if (!crossed) {
    if (!(eq.a > 0) || !(eq.h_squared > 0)) return;
    const double bottom = eq.b / eq.a;
    if (line.climb != 0 && !(low < bottom && bottom < high)) return;
    const auto [in, out] = stable_roots(eq.a, eq.b, eq.c, std::sqrt(eq.h_squared));
    cuts.push_back({in, face});
    cuts.push_back({out, face});
    return;
  }

  // One crossing: of the two roots the one that goes the right way, inwards if the line is outside at the end it passes
  // first. It lies between the ends; a line along the piece, whose roots are all rounding, is kept there.
  const bool inwards = at_a < at_b ? starts_outside : ends_outside;
  double t = low;
  if (eq.a != 0) {
    const auto [first, second] = stable_roots(eq.a, eq.b, eq.c, std::sqrt(std::max(0.0, eq.h_squared)));
    t = inwards == (eq.a > 0) ? first : second;
  } else if (eq.b != 0) {
    t = eq.c / (2 * eq.b);
  }
  cuts.push_back({on_piece && t == 0 ? t : std::clamp(t, low, high), face});
}

void Lathe::find_cuts(const AxisLine& line, const Departure* left, std::vector<Cut>& cuts) const {
  // Decide once a corner on which side of its circle the line passes at its height; a level line, which never comes to
  // that height, passes beside the pieces that reach across its own, and dips into them twice or never. A corner on the
  // axis has no circle to pass inside of.
  struct Passed {
    bool beside = false;
    double across = 0, radius_squared = 0;
  };
  const double missed = line.miss * line.miss;
  const bool level = line.climb == 0;
  const auto pass = [&](const Corner& corner) {
    if (level) return Passed{corner.height > line.height, 0, corner.radius * corner.radius};
    const double across = line.across_at((corner.height - line.height) / line.climb);
    const double square = corner.radius * corner.radius;
    return Passed{corner.radius == 0 || across * across + missed > square, across, square};
  };

  // Beside both ends, a piece is out of reach if the line comes no nearer to the axis between them than its wider end.
  const auto is_out_of_reach = [&](const Passed& a, const Passed& b) {
    const bool same_side = (a.across < 0) == (b.across < 0);
    const double nearest = level || !same_side ? 0 : std::min(std::abs(a.across), std::abs(b.across));
    return nearest * nearest + missed >= std::max(a.radius_squared, b.radius_squared);
  };
  const auto look_at = [&](const Run& run) {
    Passed before = pass(corners_[run.first]);
    for (std::uint32_t face = run.first; face < run.end; ++face) {
      const Passed next = pass(after(face));
      const bool both = level ? before.beside != next.beside : before.beside && next.beside;
      const bool reached = both ? !is_out_of_reach(before, next) : !level && before.beside != next.beside;
      if (reached && !pieces_[face].on_axis)
        cut_piece(line, face, both || before.beside, both || next.beside, departs_from(left, face), cuts);
      before = next;
    }
  };
  for (std::uint32_t i = 0; i < runs_.size();) {
    const Run& run = runs_[i];
    const bool skips = passes_by(line, run);
    if (!skips && run.whole) look_at(run);
    i = skips ? run.next : i + 1;
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& x, const Cut& y) { return x.t < y.t; });
}

bool Lathe::intersect(const Ray& ray, const Departure* left, ShapeHit& hit) const {
  // Solve about the point of the line next to the middle, but a ray that stands on the surface about its origin.
  Vec3 offset = ray.origin - middle_;
  const double ahead = left == nullptr ? -dot(offset, ray.direction) : 0;
  offset = offset + ray.direction * ahead;
  if (left == nullptr && length_squared(offset) > reach_ * reach_) return false;

  thread_local std::vector<Cut> cuts;
  thread_local std::vector<Span> spans;
  cuts.clear();
  spans.clear();
  find_cuts(AxisLine(offset, ray.direction, axis_), left, cuts);
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
    Span span;
    span.enter(cuts[i].t + ahead, cuts[i].face);
    span.leave(cuts[i + 1].t + ahead, cuts[i + 1].face);
    if (!span.is_empty()) spans.push_back(span);
  }
  return first_event(spans.data(), spans.data() + spans.size(), left, hit);
}

SurfacePoint Lathe::surface(Vec3 point, std::uint32_t face) const {
  const Vec3 offset = point - middle_;
  const double height = dot(offset, axis_);
  const Vec3 lateral = offset - axis_ * height;
  const double radius = length(lateral);
  const Vec3 outward = radius > 0 ? lateral / radius : surface_frame(axis_).u;
  const Piece& piece = pieces_[face];
  const Vec3 normal = normalise(outward * piece.out_radius + axis_ * piece.out_height);
  const Corner& corner = corners_[face];
  const double gap = (radius - corner.radius) * piece.out_radius + (height - corner.height) * piece.out_height;
  return {point - normal * gap, normal};
}

bool Lathe::contains(Vec3 point) const {
  const Vec3 offset = point - middle_;
  const double height = dot(offset, axis_), radius = length(offset - axis_ * height);

  // Count the pieces farther from the axis at this height, each half open so that a corner counts once.
  bool inside = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Corner &a = corners_[i], &b = after(i);
    if ((a.height > height) == (b.height > height)) continue;
    const double turn = (b.radius - a.radius) * (height - a.height) - (b.height - a.height) * (radius - a.radius);
    if (b.height > a.height ? turn > 0 : turn < 0) inside = !inside;
  }
  return inside;
}

Bounds Lathe::bounds() const {
  // A circle of radius r about the axis n reaches r sqrt(1 - n_i^2) along i.
  const auto reach = [](double n, double radius) { return radius * std::sqrt(std::max(0.0, (1 - n) * (1 + n))); };
  Bounds box;
  for (const Corner& corner : corners_) {
    const Vec3 center = middle_ + axis_ * corner.height;
    const Vec3 extent{reach(axis_.x, corner.radius), reach(axis_.y, corner.radius), reach(axis_.z, corner.radius)};
    box.add(center - extent);
    box.add(center + extent);
  }
  return box;
}

double Lathe::coordinate_scale() const { return largest_coordinate(middle_) + reach_; }

}  // namespace vitrail
