#pragma once
/// What photons are aimed at: the objects that reflect or transmit, each in a sphere and a box.

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/accel.h"

namespace vitrail {

struct BoundingSphere {
  Vec3 center;
  double radius = 0;
};

/// One specular object and where it is.
struct Target {
  std::uint32_t object = 0;
  BoundingSphere bound;
  Bounds box;  // inside it as well; a cube around the sphere where nothing tighter is known
};

/// What light from infinity must start outside of.
struct Surroundings : BoundingSphere {  // around everything finite
  std::vector<PlaneShape> planes;       // the infinite planes
};

struct Targets {
  std::vector<Target> targets;
  Surroundings surroundings;
  std::vector<std::string> warnings;
};

std::vector<PlaneShape> planes_of(const Scene& scene);

/// Every object whose material reflects or transmits. An infinite plane is aimed at where its mirror image of the
/// finite objects is seen: a sphere about the foot of their centre; a warning says what lies outside.
Targets find_targets(const Scene& scene, const Intersector& intersector);

}  // namespace vitrail
