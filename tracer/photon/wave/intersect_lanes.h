#pragma once
/// Intersect many rays with one shape, and compare what they met: the loops under SmallSceneIntersector.

#include "photon/wave/path_states.h"
#include "scene/scene.h"

namespace vitrail {

/// Places on a surface, with the outward unit normals there.
struct SurfaceLanes {
  static constexpr int kCapacity = RayChunk::kCapacity;
  alignas(64) std::array<std::array<double, kCapacity>, 3> point, normal;
};

/// Ask one object for every ray of a chunk, and enter the nearest hit of each into the chunk's answers. A ray does not
/// hit the flat shape that it departs from; from a sphere it departs exactly.
void intersect(const SphereShape& sphere, std::int32_t object, RayChunk& rays);
void intersect(const PlaneShape& plane, std::int32_t object, RayChunk& rays);
void intersect(const RectangleShape& rectangle, std::int32_t object, RayChunk& rays);
void intersect(const DiscShape& disc, std::int32_t object, RayChunk& rays);

/// Fill in `too_close`, after every object was asked.
void find_ties(RayChunk& rays);

/// Bring `count` points near a sphere onto it, along the radius, and find the normals there.
void project(const SphereShape& sphere, int count, SurfaceLanes& lanes);

}  // namespace vitrail
