#pragma once
/// Light that reaches a point straight from the lights. Any object in between, glass too, is a shadow [S section 4].

#include "base/random.h"
#include "light/light.h"
#include "material/surface.h"

namespace vitrail {

/// The random part of one estimate: a stream, and which sample of it this is.
struct SampleDraw {
  Stream stream;
  std::uint32_t sample = 0;
};

/// A place on a surface whose light is asked for, on the side of the viewer.
struct ShadingPoint {
  Vec3 point, normal;      // unit
  Departures departures;   // of rays that leave on that side
  const MediumSet& media;  // the solids there ...
  std::uint32_t dominant;  // ... and the one whose medium fills it
};

/// Where a path arrived; the arrival must outlive it.
inline ShadingPoint shading_point(const Arrival& arrival) {
  return {arrival.hit.point, arrival.event.facing_normal, arrival.hit.back(), arrival.media,
          arrival.event.medium_before};
}

struct DirectLight {
  Rgb irradiance;  // W/m2
  std::uint64_t shadow_rays = 0;
};

/// Irradiance at a point. The medium on its side absorbs on the way from a light that stands in it too. Lights with an
/// extent are sampled `samples_per_light` times, delta lights once.
DirectLight direct_light(const World& world, const ShadingPoint& at, SampleDraw draw, int samples_per_light);

}  // namespace vitrail
