#include "render/whitted.h"

#include <algorithm>
#include <stdexcept>

#include "render/light_bins.h"

namespace vitrail {
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
  throw std::logic_error("no such lobe");
}

}  // namespace

CameraTracer::CameraTracer(const LitWorld& world)
    : world_(world), scene_(world.scene), in_bins_(counts_in_pixels(world.scene)) {}

void CameraTracer::trace(const CameraPath& path, PathResult& result) {
  result.radiance = {};
  result.requests.clear();
  result.rays = result.shadow_rays = 0;
  path_ = path;
  ior_at_camera_ = ior_in(scene_, path.media, 0);
  pending_.clear();
  const IorSource ior = scene_.paper.disperse_camera ? IorSource::band : IorSource::camera;
  pending_.push_back({.path = {.ray = path.ray, .media = path.media, .ior = ior}});
  while (!pending_.empty()) {
    CameraVertex vertex = pending_.back();
    pending_.pop_back();
    ++result.rays;
    const Arrival arrival = advance(world_, vertex.path);
    vertex.path.weight *= arrival.transmittance;
    if (!arrival.escaped) {
      arrive(vertex, arrival, result);
      continue;
    }
    for (const Light& light : scene_.lights) {
      result.radiance[vertex.layer] += vertex.path.weight * sky_radiance(light, vertex.path.ray.direction);
    }
  }
}

// Add what the surface shows, and go on. Split into bands at the first face that tells them apart; from there each
// keeps its own index.
void CameraTracer::arrive(CameraVertex& vertex, const Arrival& arrival, PathResult& result) {
  shade(vertex, arrival, result);
  if (!splits_into_bands(scene_, vertex.path, arrival.event)) {
    scatter(vertex, arrival, arrival.event);
    return;
  }
  const Rgb throughput = vertex.path.weight;
  vertex.path.band_chosen = true;
  for (std::uint32_t band = 0; band < scene_.bands.size(); ++band) {
    vertex.path.band = band;
    vertex.path.weight = throughput * scene_.bands[band].weight;
    scatter(vertex, arrival, interact(scene_, incidence_of(vertex.path, arrival)));
  }
}

// Add what the surface itself shows: its emission, direct light, ambient light, and a request for photons.
void CameraTracer::shade(const CameraVertex& vertex, const Arrival& arrival, PathResult& result) {
  // Radiance inside glass is larger by the index squared; the camera sees it without that factor [O 1.1 row 10].
  const Interaction& event = arrival.event;
  const double ratio = ior_at_camera_ / event.index.from;
  const Rgb seen = vertex.path.weight * (ratio * ratio);
  result.radiance[vertex.layer] += seen * event.emission;
  if (is_black(event.diffuse)) return;

  const Rgb reflected = seen * event.diffuse * (1 / M_PI);
  const ShadingPoint at = shading_point(arrival);
  const DirectLight light = direct_light(world_, at, path_.draw, path_.light_samples);
  result.shadow_rays += light.shadow_rays;
  result.radiance[vertex.layer] += reflected * light.irradiance;
  result.radiance[Layer::indirect_light] += reflected * indirect(vertex, at);
  if (scene_.plan.caustic && !is_binned(vertex)) result.requests.push_back({{at.point, at.normal}, reflected});
}

// Whether the solver has already counted the photons here in the pixel that sees them directly.
bool CameraTracer::is_binned(const CameraVertex& vertex) const { return in_bins_ && vertex.path.depth.faces() == 0; }

// Constant ambient light, or what the global photon map and the final gather say.
Rgb CameraTracer::indirect(const CameraVertex& vertex, const ShadingPoint& at) const {
  if (!scene_.plan.indirect_light) return {};
  switch (scene_.transport.indirect) {
    case Indirect::none:
      return {};
    case Indirect::ambient:
      return scene_.transport.ambient;
    case Indirect::photons:
      return indirect_irradiance(world_, path_.half, at, vertex.path, {path_.gather, path_.draw.sample});
  }
  throw std::logic_error("no such kind of indirect light");
}

// Replace the path by several convoluted ones at its first rough face, and by one at the others [S eq. 8].
void CameraTracer::scatter(const CameraVertex& vertex, const Arrival& arrival, const Interaction& event) {
  if (!scene_.plan.roughness || !is_rough(event.roughness)) {
    divide(vertex, arrival, event);
    return;
  }
  const int several = vertex.scattered ? 1 : std::max(1, scene_.settings.rough_samples);
  const int count = several + (scene_.paper.literal_sum ? 1 : 0);  // the printed sum runs from 0 to n [O 1.1 row 20]
  const int bounce = 64 * vertex.path.depth.reflections + vertex.path.depth.transmissions;
  const Stream stream = within(path_.rough, static_cast<std::uint64_t>(bounce));
  CameraVertex scattered = vertex;
  scattered.scattered = true;
  scattered.path.weight = vertex.path.weight * (1.0 / several);
  for (int i = 0; i < count; ++i) {
    const auto u =
        padded_4d(stream, path_.draw.sample * static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(i));
    Interaction one = event;
    roughen(scene_, incidence_of(vertex.path, arrival), {u[0], u[1], u[2]}, Transported::importance, one);
    divide(scattered, arrival, one);
  }
}

void CameraTracer::divide(const CameraVertex& vertex, const Arrival& arrival, const Interaction& event) {
  for (const Branch* branch : {&event.transmit, &event.reflect}) {
    if (branch->exists) send(vertex, arrival, *branch);
  }
}

void CameraTracer::send(const CameraVertex& from, const Arrival& arrival, const Branch& branch) {
  const Rgb throughput = from.path.weight * branch.weight;
  const Depth depth = from.path.depth.after(branch.lobe);
  if (!(largest_channel(throughput) >= kLeastCameraShare) || !scene_.within_depth(depth)) return;
  CameraVertex& next = pending_.emplace_back(from);
  next.path.ray = {arrival.hit.point, branch.direction};
  next.path.departures = branch.departures;
  next.path.media = branch.media;
  next.path.weight = throughput;
  next.path.depth = depth;
  next.layer = layer_after(from.layer, branch.lobe);
}

}  // namespace vitrail
