#include "render/indirect_light.h"

#include "light/sampling.h"
#include "photon/walk.h"

namespace vitrail {
namespace {

constexpr int kMostSteps = 100;

// Radiance along one ray of the final gather, from the first diffuse surface behind any mirrors and glass.
Rgb gathered_radiance(const LitWorld& world, int half, PathState path, SampleDraw draw) {
  const double ior_at_start = ior_in(world.scene, path.media, path.band);
  for (int steps = 0; steps < kMostSteps; ++steps) {
    const Arrival arrival = advance(world, path);
    if (arrival.escaped) return {};
    path.weight *= arrival.transmittance;
    const Interaction& event = arrival.event;
    const Stream stream = within(draw.stream, static_cast<std::uint64_t>(steps));
    const auto u = padded_4d(stream, draw.sample);

    // Stop at the diffuse part with its own probability, or go on through the specular part.
    const double diffuse = largest_channel(event.diffuse);
    const bool specular = event.reflect.exists || event.transmit.exists;
    const double stops = !specular ? 1 : 0.5 * diffuse;
    if (u[0] < stops) {
      const GatherQuery query{arrival.hit.point, event.facing_normal};
      Rgb irradiance = direct_light(world, shading_point(arrival), {within(stream, 1), draw.sample}, 1).irradiance;
      irradiance += world.maps.caustic.irradiance(half, query);
      irradiance += world.maps.indirect.irradiance(half, query);
      const double ratio = ior_at_start / event.index.from;
      return path.weight * event.diffuse * irradiance * (ratio * ratio / (M_PI * stops));
    }
    path.weight = path.weight * (1 / (1 - stops));
    const StepSample sample{(u[0] - stops) / (1 - stops), u[1], u[2], u[3]};
    if (step(world.scene, arrival, sample, Transported::importance, path) == SampledLobe::none) return {};
  }
  return {};
}

}  // namespace

Rgb indirect_irradiance(const LitWorld& world, int half, const ShadingPoint& at, const PathState& seen_by,
                        SampleDraw draw) {
  const int rays = world.scene.settings.final_gather_rays;
  if (rays <= 0) return world.maps.indirect.irradiance(half, {at.point, at.normal});
  Rgb sum;
  for (int i = 0; i < rays; ++i) {
    const std::uint32_t index = draw.sample * static_cast<std::uint32_t>(rays) + static_cast<std::uint32_t>(i);
    const auto u = padded_2d(draw.stream, index);
    const PathState path{.ray = {at.point, cosine_direction(at.normal, unit_point(u[0], u[1]))},
                         .departures = at.departures,
                         .media = at.media,
                         .band = seen_by.band,
                         .band_chosen = seen_by.band_chosen};
    sum += gathered_radiance(world, half, path, {within(draw.stream, 0), index});
  }
  return sum * (M_PI / rays);
}

}  // namespace vitrail
