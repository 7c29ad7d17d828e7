#include "render/whitted.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/light_bins.h"

namespace vitrail {
namespace {

// Behind dark glass a look may be faint and still all that the pixel shows; a path that carries less than this is not.
constexpr double kFaintest = 1e-6;

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

// Add light that a path brings.
void show(const CameraVertex& vertex, Layer layer, Rgb light, PathResult& result) {
  result.radiance[layer] += light;
  result.light.add(vertex.whole, light);
}

}  // namespace

CameraTracer::CameraTracer(const LitWorld& world)
    : world_(world), scene_(world.scene), in_bins_(counts_in_pixels(world.scene, world.maps.caustic)) {}

void CameraTracer::trace(const CameraPath& path, PathResult& result) {
  result.radiance = {};
  result.requests.clear();
  result.cut.clear();
  result.light = {};
  result.rays = result.shadow_rays = 0;
  result.left_to_chance = false;
  path_ = path;
  ior_at_camera_ = ior_in(scene_, path.media, 0);
  rays_ = 0;
  pending_.clear();
  const IorSource ior = scene_.paper.disperse_camera ? IorSource::band : IorSource::camera;
  pending_.push_back({.path = {.ray = path.ray, .media = path.media, .ior = ior}, .branch = path.branch});
  while (!pending_.empty()) {
    CameraVertex vertex = pending_.back();
    pending_.pop_back();
    ++result.rays;
    rays_ += vertex.part;
    const Arrival arrival = advance(world_, vertex.path);
    vertex.path.weight *= arrival.transmittance;
    if (!arrival.escaped) {
      if (survives(vertex, result)) arrive(vertex, arrival, result);
      continue;
    }
    for (const Light& light : scene_.lights) {
      show(vertex, vertex.layer, vertex.path.weight * sky_radiance(light, vertex.path.ray.direction), result);
    }
  }
}

// End a path that carries next to nothing, or let it stand for others like it.
bool CameraTracer::survives(CameraVertex& vertex, PathResult& result) const {
  const double carried = largest_channel(vertex.path.weight);
  if (carried >= kFaintest || scene_.settings.branch_share == 0) return carried > 0;
  if (!(chance_at(vertex, result, 1) * kFaintest < carried)) return false;
  vertex.path.weight = vertex.path.weight * (kFaintest / carried);
  return true;
}

// Add what the surface shows, and go on. Split into bands at the first face that tells them apart; from there each
// keeps its own index.
void CameraTracer::arrive(CameraVertex& vertex, const Arrival& arrival, PathResult& result) {
  shade(vertex, arrival, result);
  if (!splits_into_bands(scene_, vertex.path, arrival.event)) {
    scatter(vertex, arrival, arrival.event, result);
    return;
  }
  vertex.path.band_chosen = true;
  if (vertex.share < least_share(scene_.settings.branch_share, rays_)) {
    follow_one_band(vertex, arrival, result);
    return;
  }
  for (std::uint32_t band = 0; band < scene_.bands.size(); ++band) follow_band(vertex, arrival, band, 1, result);
}

void CameraTracer::follow_band(const CameraVertex& vertex, const Arrival& arrival, std::uint32_t band, double factor,
                               PathResult& result) {
  const Rgb& weight = scene_.bands[band].weight;
  CameraVertex in_band = vertex;
  in_band.path.band = band;
  in_band.path.weight *= weight * factor;
  in_band.part *= (weight.r + weight.g + weight.b) / 3 * factor;
  in_band.branch = within(vertex.branch, band);
  scatter(in_band, arrival, interact(scene_, incidence_of(in_band.path, arrival)), result);
}

// Let one band stand for all, chosen by what it carries.
void CameraTracer::follow_one_band(const CameraVertex& vertex, const Arrival& arrival, PathResult& result) {
  const auto carried = [&](const Band& band) { return largest_channel(vertex.path.weight * band.weight); };
  double sum = 0;
  for (const Band& band : scene_.bands) sum += carried(band);
  double left = chance_at(vertex, result, 0) * sum;
  std::uint32_t chosen = 0;
  for (std::uint32_t band = 0; band < scene_.bands.size(); ++band) {
    if (!(carried(scene_.bands[band]) > 0)) continue;
    chosen = band;
    if (left < carried(scene_.bands[band])) break;
    left -= carried(scene_.bands[band]);
  }
  follow_band(vertex, arrival, chosen, sum / carried(scene_.bands[chosen]), result);
}

// Add what the surface itself shows: its emission, direct light, ambient light, and a request for photons.
void CameraTracer::shade(const CameraVertex& vertex, const Arrival& arrival, PathResult& result) {
  // Radiance inside glass is larger by the index squared; the camera sees it without that factor [O 1.1 row 10].
  const Interaction& event = arrival.event;
  const double ratio = ior_at_camera_ / event.index.from;
  const Rgb seen = vertex.path.weight * (ratio * ratio);
  show(vertex, vertex.layer, seen * event.emission, result);
  if (is_black(event.diffuse)) return;

  const Rgb reflected = seen * event.diffuse * (1 / M_PI);
  const ShadingPoint at = shading_point(arrival);
  const DirectLight light = direct_light(world_, at, path_.draw, light_samples(vertex));
  result.shadow_rays += light.shadow_rays;
  show(vertex, vertex.layer, reflected * light.irradiance, result);
  show(vertex, Layer::indirect_light, reflected * indirect(vertex, at), result);
  if (!scene_.plan.caustic || is_binned(vertex)) return;
  const auto is_flat = [&](const Crossing& c) { return has_flat_faces(scene_.objects[c.object].shape); };
  const bool on_flat = std::all_of(arrival.hit.crossings.begin(), arrival.hit.crossings.end(), is_flat);
  result.requests.push_back({.query = {at.point, at.normal}, .weight = reflected, .on_flat = on_flat});
}

// A lamp with an extent is sampled in proportion to what this path adds to the look: the noise of all together is then
// that of a look at one surface.
int CameraTracer::light_samples(const CameraVertex& vertex) const {
  return std::max(1, static_cast<int>(std::lround(path_.light_samples * vertex.share)));
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
void CameraTracer::scatter(const CameraVertex& vertex, const Arrival& arrival, const Interaction& event,
                           PathResult& result) {
  if (!scene_.plan.roughness || !is_rough(event.roughness)) {
    divide(vertex, arrival, event, result);
    return;
  }
  const int several = vertex.scattered ? 1 : std::max(1, scene_.settings.rough_samples);
  const int count = several + (scene_.paper.literal_sum ? 1 : 0);  // the printed sum runs from 0 to n [O 1.1 row 20]
  const int bounce = 64 * vertex.path.depth.reflections + vertex.path.depth.transmissions;
  const Stream stream = within(path_.rough, static_cast<std::uint64_t>(bounce));
  CameraVertex scattered = vertex;
  scattered.scattered = true;
  scattered.path.weight = vertex.path.weight * (1.0 / several);
  scattered.part = vertex.part / several;
  for (int i = 0; i < count; ++i) {
    const auto u =
        padded_4d(stream, path_.draw.sample * static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(i));
    Interaction one = event;
    roughen(scene_, incidence_of(vertex.path, arrival), {u[0], u[1], u[2]}, Transported::importance, one);
    scattered.branch = within(vertex.branch, static_cast<std::uint64_t>(i));
    divide(scattered, arrival, one, result);
  }
}

// How the share of a path divides among its two ways on and the light that the surface scatters.
CarriedShares CameraTracer::shares_of(const CameraVertex& vertex, const Interaction& event) const {
  const auto carried = [&](const Rgb& part) { return largest_channel(vertex.path.weight * part); };
  const double transmitted = event.transmit.exists ? carried(event.transmit.weight) : 0;
  const double reflected = event.reflect.exists ? carried(event.reflect.weight) : 0;
  const double sum = transmitted + reflected + carried(event.diffuse);
  if (!(sum > 0)) return {};
  return {vertex.share * (transmitted / sum), vertex.share * (reflected / sum)};
}

// Go on both ways, or leave to chance what this look would hardly see.
void CameraTracer::divide(const CameraVertex& vertex, const Arrival& arrival, const Interaction& event,
                          PathResult& result) {
  const std::array<const Branch*, 2> ways{&event.transmit, &event.reflect};
  const CarriedShares shares = shares_of(vertex, event);
  CarriedShares carried{};
  for (std::size_t way = 0; way < 2; ++way) {
    if (!(shares[way] > 0)) continue;
    if (scene_.within_depth(vertex.path.depth.after(ways[way]->lobe))) {
      carried[way] = shares[way];
    } else {
      cut(vertex, event, ways[way]->lobe, shares[way], result);
    }
  }
  BranchFactors factors{1, 1};
  const double least = least_share(scene_.settings.branch_share, rays_);
  if (leaves_to_chance(carried, least)) {
    factors = share_out(carried, least, chance_at(vertex, result, 0));
  }

  // The stronger way is followed first, while the look has taken few rays.
  const std::size_t weaker = carried[0] < carried[1] ? 0 : 1;
  for (const std::size_t way : {weaker, 1 - weaker}) {
    if (carried[way] > 0 && factors[way] > 0) send(vertex, arrival, *ways[way], carried[way], factors[way]);
  }
}

// A number of chance for this place of the tree, spread evenly over the samples of the pixel.
double CameraTracer::chance_at(const CameraVertex& vertex, PathResult& result, int draw) const {
  result.left_to_chance = true;
  return padded_2d(vertex.branch, path_.draw.sample)[static_cast<std::size_t>(draw)];
}

// Book a branch that goes beyond the limits of the scene.
void CameraTracer::cut(const CameraVertex& vertex, const Interaction& event, Lobe lobe, double share,
                       PathResult& result) const {
  const bool mirrored = scene_.paper.count_transmission || lobe == Lobe::reflection;
  result.cut.push_back({.share = share * vertex.part,
                        .limit = mirrored ? Limit::max_reflections : Limit::max_transmissions,
                        .object = event.object,
                        .layer = layer_after(vertex.layer, lobe)});
}

void CameraTracer::send(const CameraVertex& from, const Arrival& arrival, const Branch& branch, double share,
                        double factor) {
  CameraVertex& next = pending_.emplace_back(from);
  next.path.ray = {arrival.hit.point, branch.direction};
  next.path.departures = branch.departures;
  next.path.media = branch.media;
  next.path.weight = from.path.weight * branch.weight * factor;
  next.path.depth = from.path.depth.after(branch.lobe);
  next.share = share * factor;
  next.whole = from.whole * (share / from.share);
  next.layer = layer_after(from.layer, branch.lobe);
  next.branch = within(from.branch, static_cast<std::uint64_t>(branch.lobe));
}

}  // namespace vitrail
