#pragma once
/// A tree of boxes over many primitives. Embree walks the boxes in single precision; every hit is decided by us in
/// double.

#include <memory>
#include <vector>

#include "geometry/nearest.h"
#include "geometry/primitive.h"

namespace vitrail {

/// Something with a box: an analytic object, or one triangle of a mesh.
struct TreeItem {
  static constexpr std::uint32_t kWhole = 0xffffffffu;
  std::uint32_t object = 0;
  std::uint32_t triangle = kWhole;
};

class EmbreeSearch {
 public:
  /// All items have finite boxes. `primitives` is indexed by object and must outlive the search.
  EmbreeSearch(const std::vector<Primitive>& primitives, std::vector<TreeItem> items);
  ~EmbreeSearch();

  /// Offer every hit that could be the nearest.
  void closest(const Ray& ray, const Departures& departures, Nearest& nearest) const;
  /// The items whose boxes hold a point, in no order.
  void around(Vec3 point, std::vector<TreeItem>& items) const;
  /// Whether anything is hit at 0 < t < t_max.
  bool occluded(const Ray& ray, const Departures& departures, double t_max) const;

  struct State;  // public in name only: the callbacks of Embree see it

 private:
  std::unique_ptr<State> state_;
};

}  // namespace vitrail
