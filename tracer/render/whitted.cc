#include "render/whitted.h"

#include <algorithm>

#include "render/light_bins.h"

namespace vitrail {

CameraTracer::CameraTracer(const Scene& scene, const Intersector& intersector, const LightMaps& maps)
    : scene_(scene), intersector_(intersector), maps_(maps), in_bins_(counts_in_pixels(scene)) {
  for (const Material& material : scene.materials) {
    const auto& ior = material.ior_by_band;
    disperses_.push_back(std::any_of(ior.begin(), ior.end(), [&](double n) { return n != ior[0]; }));
  }
}

void CameraTracer::trace(const CameraPath& path, PathResult& result) {
  result.radiance = {};
  result.requests.clear();
  result.rays = result.shadow_rays = 0;
  path_ = path;
  const bool undispersed = !scene_.paper.disperse_camera;
  ior_at_camera_ = ior_in(scene_, path.media, 0);
  pending_.clear();
  pending_.push_back({path.ray, {}, path.media, {1, 1, 1}});
  while (!pending_.empty()) {
    const Look look = pending_.back();
    pending_.pop_back();
    ++result.rays;
    const Arrival arrival =
        advance(scene_, intersector_, look.ray, look.departures, look.media, look.band, undispersed);
    if (arrival.escaped) {
      const Rgb seen = look.throughput * arrival.transmittance;
      for (const Light& light : scene_.lights) {
        result.radiance[look.layer] += seen * sky_radiance(light, look.ray.direction);
      }
      continue;
    }
    const Rgb throughput = look.throughput * arrival.transmittance;

    // Split into bands at the first face that tells them apart; from there each keeps its own index.
    const auto tells_apart = [&](std::uint32_t object) {
      return object != kAir && disperses_[scene_.objects[object].material];
    };
    const Interaction& event = arrival.event;
    const bool split = !undispersed && !look.band_chosen && event.transmit.exists &&
                       (tells_apart(event.medium_before) || tells_apart(event.medium_after));
    scatter(look, arrival, event, throughput, result);
    if (!split) {
      go_on(look, arrival, event, throughput);
      continue;
    }
    for (std::uint32_t band = 0; band < scene_.bands.size(); ++band) {
      Look one = look;
      one.band = band;
      one.band_chosen = true;
      const Interaction in_band = interact(scene_, arrival.hit, look.ray.direction, arrival.media, band);
      go_on(one, arrival, in_band, throughput * scene_.bands[band].weight);
    }
  }
}

// Add what the surface itself shows: its emission, direct light, ambient light, and a request for photons.
void CameraTracer::scatter(const Look& look, const Arrival& arrival, const Interaction& event, Rgb throughput,
                           PathResult& result) {
  // Radiance inside glass is larger by the index squared; the camera sees it without that factor [O 1.1 row 10].
  const double ratio = ior_at_camera_ / event.index.from;
  const Rgb seen = throughput * (ratio * ratio);
  result.radiance[look.layer] += seen * event.emission;
  if (is_black(event.diffuse)) return;

  const Rgb reflected = seen * event.diffuse * (1 / M_PI);
  const DirectLight light =
      direct_light(scene_, intersector_, arrival.hit.point, event.facing_normal, arrival.hit.back(),
                   {arrival.media, event.medium_before}, path_.draw, path_.light_samples);
  result.shadow_rays += light.shadow_rays;
  result.radiance[look.layer] += reflected * light.irradiance;
  result.radiance[Layer::indirect_light] += reflected * indirect(look, arrival, event);
  if (scene_.plan.caustic && !is_binned(look))
    result.requests.push_back({{arrival.hit.point, event.facing_normal}, reflected});
}

// Whether the solver has already counted the photons here in the pixel that sees them directly.
bool CameraTracer::is_binned(const Look& look) const { return in_bins_ && look.depth.faces() == 0; }

// Constant ambient light, or what the global photon map and a look around say.
Rgb CameraTracer::indirect(const Look& look, const Arrival& arrival, const Interaction& event) const {
  if (!scene_.plan.indirect_light) return {};
  switch (scene_.transport.indirect) {
    case Indirect::none:
      return {};
    case Indirect::ambient:
      return scene_.transport.ambient;
    case Indirect::photons: {
      const SeenPoint seen{arrival.hit.point, event.facing_normal, arrival.hit.back(),
                           arrival.media,     look.band,           look.band_chosen};
      return indirect_irradiance(scene_, intersector_, maps_, path_.half, seen, {path_.around, path_.draw.sample});
    }
  }
  __builtin_unreachable();
}

// Replace the look by several convoluted ones at the first rough face of a path, and by one at the others [S eq. 8].
void CameraTracer::go_on(const Look& look, const Arrival& arrival, const Interaction& event, Rgb throughput) {
  if (!scene_.plan.roughness || !is_rough(event.roughness)) {
    meet(look, arrival, event, throughput);
    return;
  }
  const int several = look.scattered ? 1 : std::max(1, scene_.settings.rough_samples);
  const int count = several + (scene_.paper.literal_sum ? 1 : 0);  // the printed sum runs from 0 to n [O 1.1 row 20]
  const int bounce = 64 * look.depth.reflections + look.depth.transmissions;
  const Stream stream = within(path_.rough, static_cast<std::uint64_t>(bounce));
  Look scattered = look;
  scattered.scattered = true;
  for (int i = 0; i < count; ++i) {
    const auto u =
        padded_4d(stream, path_.draw.sample * static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(i));
    Interaction one = event;
    roughen(scene_, arrival.hit, look.ray.direction, arrival.media, {u[0], u[1], u[2]}, Travels::look, one);
    meet(scattered, arrival, one, throughput * (1.0 / several));
  }
}

void CameraTracer::meet(const Look& look, const Arrival& arrival, const Interaction& event, Rgb throughput) {
  for (const Branch* branch : {&event.transmit, &event.reflect}) {
    if (branch->exists) send(look, arrival, *branch, throughput * branch->weight);
  }
}

namespace {

// The first specular event names the layer, total internal reflection anywhere overrides it.
Layer layer_after(Layer before, Lobe lobe) {
  switch (lobe) {
    case Lobe::total_internal_reflection:
      return Layer::total_internal_reflection;
    case Lobe::reflection:
      return before == Layer::diffusion ? Layer::reflection : before;
    case Lobe::transmission:
      return before == Layer::diffusion ? Layer::refraction : before;
  }
  __builtin_unreachable();
}

}  // namespace

void CameraTracer::send(const Look& look, const Arrival& arrival, const Branch& branch, Rgb throughput) {
  const Depth depth = look.depth.after(branch.lobe);
  if (!(largest_channel(throughput) >= kLeastCameraShare) || !scene_.within_depth(depth)) return;
  pending_.push_back({{arrival.hit.point, branch.direction},
                      branch.departures,
                      branch.media,
                      throughput,
                      look.band,
                      look.band_chosen,
                      depth,
                      look.scattered,
                      layer_after(look.layer, branch.lobe)});
}

}  // namespace vitrail
