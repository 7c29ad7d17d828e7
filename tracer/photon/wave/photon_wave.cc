#include "photon/wave/photon_wave.h"

#include <algorithm>

#include "material/roughen.h"
#include "optics/absorption.h"

namespace vitrail {
namespace {

// What the wave leaves to the tree: facets under the letter of the paper, where total reflection drops light.
bool drops_light_at_facets(const Scene& scene) {
  const auto is_ggx = [](const Material& material) { return std::holds_alternative<Ggx>(material.roughness); };
  return scene.plan.roughness && scene.paper.tir_drop &&
         std::any_of(scene.materials.begin(), scene.materials.end(), is_ggx);
}

bool is_sheet(const Shape& shape) {
  return std::holds_alternative<RectangleShape>(shape) || std::holds_alternative<DiscShape>(shape);
}

}  // namespace

bool PhotonWave::suits(const Scene& scene) {
  return !drops_light_at_facets(scene) && !scene.paper.refraction_literal && SmallSceneIntersector::suits(scene);
}

PhotonWave::PhotonWave(const PhotonPass& pass, std::uint32_t target, Stream stream, const BandCombs& combs,
                       const PhotonBranches& branches, PhotonBlock& block)
    : pass_(pass),
      scene_(pass.scene),
      target_(static_cast<std::int32_t>(target)),
      block_(block),
      objects_(pass.scene),
      store_(pass.frame, block),
      tree_(pass, target, stream, store_, block.ledger, combs, branches),
      met_(4 * pass.scene.objects.size()),
      rays_(std::make_unique<RayChunk>()),
      group_(std::make_unique<Group>()),
      lanes_(std::make_unique<DielectricLanes>()),
      lots_(stream),
      combs_(combs),
      branches_(branches),
      samples_(std::make_unique<RoughSamples>()),
      facets_(std::make_unique<FacetLanes>()) {
  for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
    const Material& material = scene_.material_of(i);
    faces_.push_back({.material = &material,
                      .pool = material.reflection + material.transmission,
                      .transmits = material.transmits(),
                      .mirrors = !is_black(material.reflection),
                      .is_sheet = is_sheet(scene_.objects[i].shape),
                      .stores = can_be_diffuse(material),
                      .disperses = is_dispersive(scene_, i),
                      .absorbs = !is_black(material.absorption_per_m),
                      .rough = scene_.plan.roughness && is_rough(material.roughness),
                      .priority = scene_.objects[i].priority});
    anything_absorbs_ = anything_absorbs_ || faces_.back().absorbs;
  }
}

void PhotonWave::add(const Ray& ray, Rgb flux, std::uint32_t index) {
  now_.add(ray.origin, ray.direction, flux, kLeastPhotonShare * largest_channel(flux), {}, {.index = index});
}

void PhotonWave::add(const Ray& ray, const MediumSet& media, Rgb flux, std::uint32_t index) {
  const double least = kLeastPhotonShare * largest_channel(flux);
  if (media.size() > 1) {
    tree_.follow({.path = {.ray = ray, .media = media, .weight = flux}, .least = least, .index = index});
    return;
  }
  DiscreteState state{.index = index};
  if (media.size() == 1) state.medium = static_cast<std::int32_t>(media[0]);
  now_.add(ray.origin, ray.direction, flux, least, {}, state);
}

// Let all photons under way have one event, then all their branches, and so on until none is left.
void PhotonWave::finish() {
  while (now_.size() > 0) {
    next_.clear();
    for (std::size_t first = 0; first < now_.size(); first += RayChunk::kCapacity) {
      step(first, std::min<std::size_t>(RayChunk::kCapacity, now_.size() - first));
    }
    std::swap(now_, next_);
  }
}

// Find what the photons meet, and sort them by it.
void PhotonWave::step(std::size_t first, std::size_t count) {
  RayChunk& rays = *rays_;
  rays.count = static_cast<int>(count);
  for (int a = 0; a < 3; ++a) {
    rays.origin[a] = now_.origin(a) + first;
    rays.direction[a] = now_.direction(a) + first;
  }
  rays.departed = now_.departed() + first;
  rays.states = now_.states() + first;
  objects_.find(rays);

  for (std::size_t i = 0; i < count; ++i) {
    const HitId met = HitId::of_lane(rays.met[i]);
    if (met.object == kNoObject) {
      escape(first + i);
    } else if (rays.too_close[i] || !is_plain(now_.state(first + i).medium, met)) {
      follow_generally(first + i);
    } else if (met.object == target_ || now_.state(first + i).has_bounced()) {
      const bool chosen = now_.state(first + i).band != kNoBand;
      met_[2 * static_cast<std::size_t>(rays.met[i]) + (chosen ? 1 : 0)].push_back(static_cast<std::uint16_t>(i));
    }  // else leave the photon to the chart of what it meets, or to direct light
  }
  for (std::size_t kind = 0; kind < met_.size(); ++kind) {
    if (met_[kind].empty()) continue;
    arrive(HitId::of_lane(static_cast<std::int64_t>(kind / 2)), met_[kind], first);
    met_[kind].clear();
  }
}

// In air meeting anything, or inside one glass meeting its own face or something opaque that it does not displace.
bool PhotonWave::is_plain(std::int32_t medium, HitId met) const {
  const Face& face = faces_[static_cast<std::size_t>(met.object)];
  if (face.transmits) return !face.is_sheet && medium == (met.entering ? kNoObject : met.object);
  return medium == kNoObject || faces_[static_cast<std::size_t>(medium)].priority <= face.priority;
}

void PhotonWave::escape(std::size_t lane) {
  const DiscreteState& state = now_.state(lane);
  if (!state.has_bounced()) return;
  const Rgb flux = now_.flux(lane);
  Rgb left = flux;
  if (state.medium != kNoObject) {
    const Face& medium = faces_[static_cast<std::size_t>(state.medium)];
    left *= transmittance(medium.material->absorption_per_m, kInfinity);
  }
  block_.ledger.absorbed += flux - left;
  block_.ledger.escaped += left;
}

void PhotonWave::follow_generally(std::size_t lane) {
  const DiscreteState& state = now_.state(lane);
  const HitId departed = HitId::of_lane(now_.departed()[lane]);
  LightVertex photon{.least = now_.least(lane), .share = now_.share(lane), .index = state.index};
  PathState& path = photon.path;
  path.ray = now_.ray(lane);
  if (departed.object != kNoObject) {
    path.departures.push_back({static_cast<std::uint32_t>(departed.object),
                               static_cast<std::uint32_t>(state.departed_face), departed.entering});
  }
  if (state.medium != kNoObject) path.media.enter(static_cast<std::uint32_t>(state.medium));
  path.weight = now_.flux(lane);
  path.band_chosen = state.band != kNoBand;
  path.band = path.band_chosen ? static_cast<std::uint32_t>(state.band) : 0;
  path.depth = state.depth();
  tree_.follow(photon);
}

}  // namespace vitrail
