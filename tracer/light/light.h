#pragma once
/// All kinds of light behind two questions: what arrives here, and which photons leave towards the glass.

#include <variant>

#include "light/area.h"
#include "light/directional.h"
#include "light/environment.h"
#include "light/point.h"

namespace vitrail {

/// What the light sends to a point of a surface with this normal (which only an environment uses).
Illumination illuminate(const Light& light, Vec3 point, Vec3 normal, const UnitPoint& sample);

/// Whether one sample of the light says all: no extent, so every sample is the same.
bool is_delta(const Light& light);

/// What a look into the open sees of this light, W / (sr m2): an environment, nothing of the others.
Rgb sky_radiance(const Light& light, Vec3 direction);

/// The photons of one light towards one target.
struct Chart {
  std::uint32_t light = 0;
  std::uint32_t target = 0;  // object: a photon that meets another object first belongs to another chart, or to none
  std::variant<DirectionalChart, ConeChart, AreaChart, EnvironmentChart> domain;
  Rgb power;                // W, before it is known which photons meet the target
  std::uint64_t count = 0;  // photons in each half
};

/// One chart for each light and target; photons_per_half shared out in proportion to power.
std::vector<Chart> make_charts(const Scene& scene, const Targets& targets, std::uint64_t photons_per_half);

/// Whether a photon of this chart takes all four coordinates of its sample, or only the first two.
bool needs_four(const Chart& chart);

Emission emit(const Chart& chart, const EmissionSample& sample);
/// Fill in the emissions of all samples; the second point of a sample is read only if the chart needs four coordinates.
void emit(const Chart& chart, EmissionColumns& columns);

}  // namespace vitrail
