#include "photon/walk.h"

#include <algorithm>

#include "light/sampling.h"

namespace vitrail {
namespace {

// The share of the light that a lobe carries, in the channel where the result is strongest.
double probability(Rgb weight, Rgb share) { return largest_channel(weight * share) / largest_channel(weight); }

// At the first face that tells bands apart draw one of them, each as likely as the others. The number that chose is
// spread over (0, 1) again, so that it may still choose something else.
void choose_band(const Scene& scene, const Arrival& arrival, double& u, PathState& path, Interaction& event) {
  if (!splits_into_bands(scene, path, event)) return;
  const auto count = static_cast<double>(scene.bands.size());
  path.band = static_cast<std::uint32_t>(std::min(count - 1, u * count));
  path.band_chosen = true;
  u = u * count - path.band;
  path.weight *= scene.bands[path.band].weight * count;
  event = interact(scene, incidence_of(path, arrival));
}

}  // namespace

SampledLobe step(const Scene& scene, const Arrival& arrival, const StepSample& sample, Transported transported,
                 PathState& path) {
  Interaction event = arrival.event;
  double spare = sample[3];
  choose_band(scene, arrival, spare, path, event);
  if (!(largest_channel(path.weight) > 0)) return SampledLobe::none;
  if (scene.plan.roughness && is_rough(event.roughness)) {
    roughen(scene, incidence_of(path, arrival), {sample[1], sample[2], spare}, transported, event);
  }

  // Draw a lobe; what none of them carries ends here.
  const double reflects = event.reflect.exists ? probability(path.weight, event.reflect.weight) : 0;
  const double transmits = event.transmit.exists ? probability(path.weight, event.transmit.weight) : 0;
  const double scatters = transported == Transported::flux ? probability(path.weight, event.diffuse) : 0;
  const double scale = std::max(1.0, reflects + transmits + scatters);
  double u = sample[0] * scale;
  const auto take = [&](const Branch& branch, double p) {
    path.ray = {arrival.hit.point, branch.direction};
    path.departures = branch.departures;
    path.media = branch.media;
    path.weight *= branch.weight * (scale / p);
    path.depth = path.depth.after(branch.lobe);
    return scene.within_depth(path.depth);
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
  path.ray = {arrival.hit.point, cosine_direction(event.facing_normal, unit_point(sample[1], sample[2]))};
  path.departures = arrival.hit.back();
  path.media = arrival.media;
  path.weight *= event.diffuse * (scale / scatters);
  path.depth = {};
  return SampledLobe::diffuse;
}

}  // namespace vitrail
