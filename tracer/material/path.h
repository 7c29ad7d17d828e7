#pragma once
/// One ray followed through a scene, vertex by vertex, along one branch at each.

#include <string>
#include <vector>

#include "material/surface.h"

namespace vitrail {

enum class PathEvent { enter, exit, reflect, total_internal_reflection, diffuse, absorb, escape };
const char* event_name(PathEvent event);

struct PathVertex {
  PathEvent event = PathEvent::escape;
  Vec3 point;  // in the coordinates of the centred scene; meaningless for escape
  Vec3 direction_in, direction_out;
  Vec3 normal;                  // facing the arriving ray
  std::uint32_t object = kAir;  // kAir for escape
  std::uint32_t medium = kAir;  // in which the ray goes on
  double distance = 0;          // from the vertex before, metres; infinite for escape
  Rgb throughput;               // behind this vertex: all shares, tints and absorption so far
  double R = 0, T = 0;          // scalar Fresnel shares at this vertex
};

enum class FollowedBranch { transmit, reflect };

/// Follow a ray; where the wanted branch does not exist, the other one. Ends at a diffuse or absorbing surface, in the
/// open, or after max_vertices.
std::vector<PathVertex> follow(const World& world, const Ray& ray, std::uint32_t band, FollowedBranch wanted,
                               int max_vertices);

}  // namespace vitrail
