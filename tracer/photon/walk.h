#pragma once
/// One step of a random walk through mirrors, glass and diffuse surfaces: which way on, and what it then carries.

#include "base/random.h"
#include "material/roughen.h"

namespace vitrail {

/// Light under way: a photon with a flux, or a look with a throughput.
struct Walk {
  Ray ray;
  Departures departures;
  MediumSet media;
  Rgb weight;
  std::uint32_t band = 0;
  bool band_chosen = false;
  Depth depth{};  // since the last diffuse surface
};

/// Numbers in (0, 1) for one step: which way on, two for its direction, which band.
using StepSample = std::array<double, 4>;

/// What a step drew; `none`: absorbed, or beyond the depth limits of specular lobes.
enum class SampledLobe { none, reflection, transmission, diffuse };

/// Go on from an arrival by one way, drawn with the probability of its largest channel; the weight is divided by it. A
/// diffuse way is only taken by light; a look stops at diffuse surfaces where its owner decides. `none`: absorbed, or
/// beyond the depth limits of specular ways.
SampledLobe step(const Scene& scene, const Arrival& arrival, const StepSample& sample, Travels travels, Walk& walk);

}  // namespace vitrail
