#include "photon/walk.h"

#include <algorithm>

#include "light/sampling.h"
#include "photon/flight.h"

namespace vitrail {
namespace {

// The share of the light that a way on carries, in the channel where the result is strongest.
double probability(Rgb weight, Rgb share) { return largest_channel(weight * share) / largest_channel(weight); }

Vec3 cosine_direction(Vec3 normal, double u, double v) {
  const UnitPoint point = unit_point(u, v);
  const SurfaceFrame frame = surface_frame(normal);
  const double height = std::sqrt(std::max(0.0, 1 - (point.x * point.x + point.y * point.y)));
  return normalise(frame.u * point.x + frame.v * point.y + normal * height);
}

// At the first face that tells bands apart draw one of them, each as likely as the others. The number that chose is
// spread over (0, 1) again, so that it may still choose something else.
void choose_band(const Scene& scene, const Arrival& arrival, double& u, Walk& walk, Interaction& event) {
  const bool splits = !walk.band_chosen && event.transmit.exists &&
                      (tells_bands_apart(scene, event.medium_before) || tells_bands_apart(scene, event.medium_after));
  if (!splits) return;
  const auto count = static_cast<double>(scene.bands.size());
  walk.band = static_cast<std::uint32_t>(std::min(count - 1, u * count));
  walk.band_chosen = true;
  u = u * count - walk.band;
  walk.weight *= scene.bands[walk.band].weight * count;
  event = interact(scene, arrival.hit, walk.ray.direction, arrival.media, walk.band);
}

}  // namespace

SampledLobe step(const Scene& scene, const Arrival& arrival, const StepSample& sample, Travels travels, Walk& walk) {
  Interaction event = arrival.event;
  double spare = sample[3];
  choose_band(scene, arrival, spare, walk, event);
  if (!(largest_channel(walk.weight) > 0)) return SampledLobe::none;
  if (scene.plan.roughness && is_rough(event.roughness)) {
    roughen(scene, arrival.hit, walk.ray.direction, arrival.media, {sample[1], sample[2], spare}, travels, event);
  }

  // Draw a way on; what none of them carries ends here.
  const double reflects = event.reflect.exists ? probability(walk.weight, event.reflect.weight) : 0;
  const double transmits = event.transmit.exists ? probability(walk.weight, event.transmit.weight) : 0;
  const double scatters = travels == Travels::light ? probability(walk.weight, event.diffuse) : 0;
  const double scale = std::max(1.0, reflects + transmits + scatters);
  double u = sample[0] * scale;
  const auto take = [&](const Branch& branch, double p) {
    walk.ray = {arrival.hit.point, branch.direction};
    walk.departures = branch.departures;
    walk.media = branch.media;
    walk.weight *= branch.weight * (scale / p);
    walk.depth = walk.depth.after(branch.lobe);
    return scene.within_depth(walk.depth);
  };
  if (u < reflects) {
    return take(event.reflect, reflects) ? SampledLobe::reflection : SampledLobe::none;
  }
  u -= reflects;
  if (u < transmits) {
    return take(event.transmit, transmits) ? SampledLobe::transmission : SampledLobe::none;
  }
  u -= transmits;
  if (u >= scatters) return SampledLobe::none;
  walk.ray = {arrival.hit.point, cosine_direction(event.facing_normal, sample[1], sample[2])};
  walk.departures = arrival.hit.back();
  walk.media = arrival.media;
  walk.weight *= event.diffuse * (scale / scatters);
  walk.depth = {};
  return SampledLobe::diffuse;
}

}  // namespace vitrail
