#pragma once
/// One step of a random walk through mirrors, glass and diffuse surfaces: the lobe, and what the path then carries.

#include "base/random.h"
#include "material/roughen.h"

namespace vitrail {

/// Numbers in (0, 1) for one step: the lobe, two for its direction, the band.
using StepSample = std::array<double, 4>;

/// What a step drew; `none`: absorbed, or beyond the depth limits of specular lobes.
enum class SampledLobe { none, reflection, transmission, diffuse };

/// Continue a path from its arrival by one lobe, drawn with the probability of its largest channel; the weight is
/// divided by that. Only flux takes the diffuse lobe: a camera path stops at diffuse surfaces where the caller decides.
SampledLobe step(const Scene& scene, const Arrival& arrival, const StepSample& sample, Transported transported,
                 PathState& path);

}  // namespace vitrail
