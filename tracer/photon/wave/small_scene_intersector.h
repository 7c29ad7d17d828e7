#pragma once
/// The nearest hits of many rays at once in a small scene: each object is asked for all rays in one loop of vector
/// instructions, in place of a walk through a tree for each ray. Plain doubles, no exact sums: where two surfaces lie
/// too close together to tell which is first, it says so and leaves the ray to the general search.

#include <vector>

#include "geometry/primitive.h"
#include "photon/wave/intersect_lanes.h"

namespace vitrail {

class SmallSceneIntersector {
 public:
  /// Objects with a loop of vector instructions (balls and flat shapes), and the others.
  static constexpr std::size_t kMost = 256, kMostOthers = 32;

  /// Whether the scene is small enough and has no mesh.
  static bool suits(const Scene& scene);
  explicit SmallSceneIntersector(const Scene& scene);

  /// Fill in the answers for all rays of a chunk.
  void find(RayChunk& rays) const;

  /// `lanes.point` holds `count` hits of one object to about rounding; bring them onto the surface and find the
  /// normals.
  void settle(std::uint32_t object, const std::int32_t* faces, int count, SurfaceLanes& lanes) const;

 private:
  struct Item {
    std::int32_t object;
    Shape shape;          // in world coordinates
    Primitive primitive;  // the same, for the shapes without a loop of their own
  };
  std::vector<Item> items_;
};

}  // namespace vitrail
