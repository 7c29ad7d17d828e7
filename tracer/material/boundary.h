#pragma once
/// The boundary between two media at a hit: what is on either side, and whose surface lies between.

#include "geometry/hit.h"
#include "geometry/medium_stack.h"

namespace vitrail {

struct Boundary {
  MediumSet before, after;
  std::uint32_t dominant_before = kAir, dominant_after = kAir;
  const Crossing* interface = nullptr;        // the surface that acts
  const Crossing* other_interface = nullptr;  // of the other solid of glass in contact here, if any
  std::uint32_t object = kAir;  // whose material the surface has: the interface's but for displaced solids
  bool opaque = false;          // light does not go through
};

/// The shares of a surface. Two solids in contact act like their two faces at no distance: tints multiply, the stronger
/// mirror wins; this is the same from either side and never makes light.
struct Shares {
  Rgb reflection, transmission;
  bool fresnel = false;

  Rgb pool() const { return reflection + transmission; }
};

bool is_opaque(const Scene& scene, std::uint32_t object);

/// Cross every surface of the hit at once: sets, and not the order of arrival, decide what is on the other side.
void find_boundary(const Scene& scene, const Hit& hit, const MediumSet& media, Boundary& boundary);

/// What the surface that was found there does with light.
Shares shares_of(const Scene& scene, const Boundary& boundary);

}  // namespace vitrail
