#pragma once
/// What one hit does with light: the same answer for camera rays and photons.

#include <cstdint>

#include "geometry/world.h"
#include "material/path_state.h"
#include "optics/refract.h"

namespace vitrail {

/// One way on: start at hit.point with these departures and media. Weight: what the branch carries of the arriving
/// light, already includes the material's share and the Fresnel share.
struct Branch {
  bool exists = false;
  Lobe lobe = Lobe::reflection;
  Vec3 direction;
  Rgb weight;
  Departures departures;
  MediumSet media;

  void set(Lobe which, Vec3 where_to, const Rgb& carried, const Departures& left, const MediumSet& inside) {
    exists = true;
    lobe = which;
    direction = where_to;
    weight = carried;
    departures = left;
    media = inside;
  }
};

struct Interaction {
  /// The ruling medium does not change and nothing opaque is met: go straight on along `transmit`, without an event,
  /// without a depth count. Everything else is then empty.
  bool passes = false;

  Vec3 facing_normal;                  // unit, against the arriving direction (shading normal where a mesh is smooth)
  std::uint32_t object = 0;            // whose surface it is
  std::uint32_t material = 0;          // of that object
  std::uint32_t medium_before = kAir;  // ruling object on the arriving side
  std::uint32_t medium_after = kAir;   // ... and behind the surface
  IndexPair index;                     // on the arriving side, and behind the surface
  bool entering = false;               // the ray goes against the outward normal of the surface

  Rgb diffuse;          // albedo d here (pattern resolved); exitant radiance is d E / pi
  Rgb emission;         // radiance given off here
  double R = 0, T = 1;  // scalar Fresnel shares at this angle (R + T = 1), also where the material ignores them
  bool total_internal_reflection = false;
  Branch reflect, transmit;  // exists == false where the weight is zero in every channel; rough: on either side
  Roughness roughness;       // of the surface; the directions above are those of the smooth surface
};

/// How a path comes to a hit.
struct Incidence {
  const Hit& hit;
  Vec3 direction;
  const MediumSet& media;  // before the surface
  std::uint32_t band = 0;
  IorSource ior = IorSource::band;
};

/// What a hit does with light that arrives like this.
Interaction interact(const Scene& scene, const Incidence& incidence);
/// The same into a fresh or used value, which spares a copy.
void interact(const Scene& scene, const Incidence& incidence, Interaction& result);

/// The index of the dominant medium of a set, for the radiance factor (n_camera / n_here)^2 of surfaces inside glass.
double ior_in(const Scene& scene, const MediumSet& media, std::uint32_t band);

/// The next hit that is an event, walking straight over boundary that change nothing.
struct Arrival {
  bool escaped = false;
  Hit hit;                     // hit.point is the event; hit.t the length of the last straight piece only
  double distance = 0;         // whole way, metres; infinite if escaped
  Rgb transmittance{1, 1, 1};  // Beer-Lambert of the whole way in the media passed
  MediumSet media;             // at arrival, before the surface
  Interaction event;
};
Arrival advance(const World& world, const PathState& path);

/// How a path came to its arrival.
inline Incidence incidence_of(const PathState& path, const Arrival& arrival) {
  return {arrival.hit, path.ray.direction, arrival.media, path.band, path.ior};
}

/// Whether light divides into bands here: the first face of a path that refracts them differently.
bool splits_into_bands(const Scene& scene, const PathState& path, const Interaction& event);

}  // namespace vitrail
