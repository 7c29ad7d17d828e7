#pragma once
/// The nearest hits of many rays at once in a scene of few objects: each object is asked for all rays in one loop that
/// the compiler turns into vector instructions. Plain doubles, no exact sums: where two surfaces lie too close together
/// to tell which is first, it says so and leaves the ray to the general search.

#include <cstdint>
#include <vector>

#include "geometry/medium_stack.h"
#include "geometry/primitive.h"

namespace vitrail {

/// Rays side by side, and what they meet.
struct RayLanes {
  static constexpr int kCapacity = 256;
  static constexpr std::int64_t kNone = -1;

  int count = 0;
  alignas(64) double origin_x[kCapacity], origin_y[kCapacity], origin_z[kCapacity];
  alignas(64) double direction_x[kCapacity], direction_y[kCapacity], direction_z[kCapacity];
  alignas(64) std::int64_t departed[kCapacity];       // 2 object + (1 if the ray goes on inside it), or kNone
  alignas(64) std::int64_t departed_face[kCapacity];  // of it

  // The answers: distance of the nearest hit and of the next object's, and 2 object + (1 if the ray enters it).
  alignas(64) double nearest[kCapacity], next[kCapacity];
  alignas(64) std::int64_t met[kCapacity];
  alignas(64) std::int64_t met_face[kCapacity];
};

class FewObjects {
 public:
  static constexpr std::size_t kMost = 32;

  /// Whether the scene is small enough and has no mesh.
  static bool suit(const Scene& scene);
  explicit FewObjects(const Scene& scene);

  /// Fill in the answers for all rays.
  void find(RayLanes& lanes) const;

  /// The place and outward normal of a hit.
  SurfacePoint surface(std::uint32_t object, Vec3 point, std::uint32_t face) const;

 private:
  struct Item {
    std::int64_t object;
    Shape shape;          // in world coordinates
    Primitive primitive;  // the same, for the shapes without a loop of their own
  };
  std::vector<Item> items_;
};

}  // namespace vitrail
