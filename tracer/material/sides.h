#pragma once
/// What is on the two sides of a hit, and whose surface it is.

#include "geometry/hit.h"
#include "geometry/medium_stack.h"

namespace vitrail {

struct Sides {
  MediumSet before, after;
  std::uint32_t ruler_before = kAir, ruler_after = kAir;
  const Crossing* owner = nullptr;    // the surface that acts
  const Crossing* partner = nullptr;  // the other solid of glass that touches here, if any
  std::uint32_t object = kAir;        // whose material the surface has; the owner's but for displaced solids
  bool opaque = false;                // light does not go through
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
void find_sides(const Scene& scene, const Hit& hit, const MediumSet& media, Sides& sides);

/// What the surface that was found there does with light.
Shares shares_of(const Scene& scene, const Sides& sides);

}  // namespace vitrail
