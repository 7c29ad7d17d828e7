#pragma once
/// The nearest hits of one ray while a search is under way: the same set whatever order they are offered in.

#include "geometry/span.h"

namespace vitrail {

class Nearest {
 public:
  explicit Nearest(const Ray& ray) : reach_(largest_coordinate(ray.origin)) {}

  struct Candidate {
    double t = 0;
    std::uint32_t object = 0, face = 0;
    bool entering = false;

    bool before(const Candidate& other) const { return t < other.t || (t == other.t && object < other.object); }
  };

  /// Note a hit unless it is too far behind the nearest to coincide with it. Of one object only the first counts.
  void offer(std::uint32_t object, const ShapeHit& hit) {
    // Mostly a hit is alone: the first one, one far before the others, or one far behind.
    if (hit.t > horizon()) return;
    if (empty() || hit.t + window(hit.t) < first().t) {
      found_.clear();
      found_.push_back({hit.t, object, hit.face, hit.entering});
    } else {
      offer_close(object, hit);
    }
  }

  bool empty() const { return found_.size() == 0; }
  const Candidate& first() const { return found_[0]; }
  const InlineVector<Candidate, 6>& all() const { return found_; }  // in order of (t, object)

  /// No hit beyond this distance is of interest any more.
  double horizon() const { return empty() ? kInfinity : first().t + window(first().t); }

 private:
  void offer_close(std::uint32_t object, const ShapeHit& hit);

  /// Generous against rounding at any incidence that matters; the exact test comes once the nearest hit is known.
  double window(double t) const { return (reach_ + t) * 0x1p-30; }

  double reach_;
  InlineVector<Candidate, 6> found_;
};

}  // namespace vitrail
