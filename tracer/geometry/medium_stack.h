#pragma once
/// Which solids a ray is inside of. A set with counts and not a stack: overlapping solids may be left in any order.

#include <cstdint>

#include "geometry/hit.h"
#include "scene/scene.h"

namespace vitrail {

/// No solid: air, index 1, no absorption.
inline constexpr std::uint32_t kAir = 0xffffffffu;

/// The solids that contain a point. Cheap to copy; more than 15 nested solids end the work with LimitError.
class MediumSet {
 public:
  static constexpr int kCapacity = 15;

  MediumSet() = default;
  /// Copy what is there and not the empty places: this goes along with every ray.
  MediumSet(const MediumSet& other) { *this = other; }
  MediumSet& operator=(const MediumSet& other) {
    size_ = other.size_;
    for (int i = 0; i < size_; ++i) objects_[i] = other.objects_[i], counts_[i] = other.counts_[i];
    return *this;
  }

  /// Cross one surface of an object: come in or go out. Self-overlapping meshes count, all other solids are in or out.
  void enter(std::uint32_t object, bool counted = false);
  void leave(std::uint32_t object);
  bool contains(std::uint32_t object) const;
  int size() const { return size_; }
  std::uint32_t operator[](int index) const { return objects_[index]; }

  /// The dominant object, whose medium fills the place: the highest priority, among equals the lowest object id; kAir
  /// if the set is empty.
  std::uint32_t dominant(const Scene& scene) const;

 private:
  std::uint32_t objects_[kCapacity];
  std::uint32_t counts_[kCapacity];
  int size_ = 0;
};

}  // namespace vitrail
