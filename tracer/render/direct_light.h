#pragma once
/// Light that reaches a point straight from the lights. Any object in between, glass too, is a shadow [S section 4].

#include "base/random.h"
#include "geometry/accel.h"
#include "geometry/medium_stack.h"
#include "light/light.h"

namespace vitrail {

/// The random part of one look at the lights: a stream, and which sample of it this is.
struct LightDraw {
  Stream stream;
  std::uint32_t sample = 0;
};

/// The solids on the viewer's side of a surface, and the one whose medium rules there.
struct Around {
  const MediumSet& media;
  std::uint32_t dominant = kAir;
};

struct DirectLight {
  Rgb irradiance;  // W/m2
  std::uint64_t shadow_rays = 0;
};

/// Irradiance on a surface at `point` whose unit normal faces the viewer. `departures` are those of light that leaves
/// on the viewer's side; the medium `around` that side absorbs on the way from a light that stands in it too. Lights
/// with an extent are sampled `samples_per_light` times, the others once.
DirectLight direct_light(const Scene& scene, const Intersector& intersector, Vec3 point, Vec3 normal,
                         const Departures& departures, const Around& around, LightDraw draw, int samples_per_light);

}  // namespace vitrail
