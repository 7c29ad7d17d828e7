#include "render/indirect_light.h"

#include "light/sampling.h"
#include "photon/walk.h"

namespace vitrail {
namespace {

constexpr int kMostSteps = 100;

Rgb map_irradiance(const std::unique_ptr<PhotonMap>& map, const GatherQuery& query) {
  return map ? map->irradiance(query) : Rgb{};
}

// Radiance along one look, from the first diffuse surface behind any mirrors and glass.
Rgb gathered_radiance(const Scene& scene, const Intersector& intersector, const LightMaps& maps, int half, Walk walk,
                      LightDraw draw) {
  const double ior_at_start = ior_in(scene, walk.media, walk.band);
  for (int steps = 0; steps < kMostSteps; ++steps) {
    const Arrival arrival = advance(scene, intersector, walk.ray, walk.departures, walk.media, walk.band);
    if (arrival.escaped) return {};
    walk.weight *= arrival.transmittance;
    const Interaction& event = arrival.event;
    const Stream stream = within(draw.stream, static_cast<std::uint64_t>(steps));
    const auto u = padded_4d(stream, draw.sample);

    // Stop at the diffuse part with its own probability, or go on through the specular part.
    const double diffuse = largest_channel(event.diffuse);
    const bool specular = event.reflect.exists || event.transmit.exists;
    const double stops = !specular ? 1 : 0.5 * diffuse;
    if (u[0] < stops) {
      const GatherQuery query{arrival.hit.point, event.facing_normal};
      const LightDraw light_draw{within(stream, 1), draw.sample};
      Rgb irradiance = direct_light(scene, intersector, query.position, query.normal, arrival.hit.back(),
                                    {arrival.media, event.medium_before}, light_draw, 1)
                           .irradiance;
      irradiance += maps.caustic.irradiance(half, query);
      irradiance += map_irradiance(maps.indirect.half[half], query);
      const double ratio = ior_at_start / event.index.from;
      return walk.weight * event.diffuse * irradiance * (ratio * ratio / (M_PI * stops));
    }
    walk.weight = walk.weight * (1 / (1 - stops));
    const StepSample sample{(u[0] - stops) / (1 - stops), u[1], u[2], u[3]};
    if (step(scene, arrival, sample, Travels::look, walk) == SampledLobe::none) return {};
  }
  return {};
}

}  // namespace

Rgb indirect_irradiance(const Scene& scene, const Intersector& intersector, const LightMaps& maps, int half,
                        const SeenPoint& seen, LightDraw draw) {
  const int rays = scene.settings.final_gather_rays;
  if (rays <= 0) return map_irradiance(maps.indirect.half[half], {seen.point, seen.normal});
  const SurfaceFrame frame = surface_frame(seen.normal);
  Rgb sum;
  for (int i = 0; i < rays; ++i) {
    const std::uint32_t index = draw.sample * static_cast<std::uint32_t>(rays) + static_cast<std::uint32_t>(i);
    const auto u = padded_2d(draw.stream, index);
    const UnitPoint point = unit_point(u[0], u[1]);
    const double height = std::sqrt(std::max(0.0, 1 - (point.x * point.x + point.y * point.y)));
    const Vec3 direction = normalise(frame.u * point.x + frame.v * point.y + seen.normal * height);
    const Walk look{{seen.point, direction}, seen.departures, seen.media, {1, 1, 1}, seen.band, seen.band_chosen, 0, 0};
    sum += gathered_radiance(scene, intersector, maps, half, look, {within(draw.stream, 0), index});
  }
  return sum * (M_PI / rays);
}

}  // namespace vitrail
