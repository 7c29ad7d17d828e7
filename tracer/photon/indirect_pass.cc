#include "photon/indirect_pass.h"

#include "photon/halves.h"
#include "photon/light_vertex.h"
#include "photon/walk.h"

namespace vitrail {
namespace {

// A closed white room would keep a photon for ever.
constexpr int kMostSteps = 1000;

// A sphere around everything finite, the camera and the lamps, so that lamps in the scene shine in every direction.
BoundingSphere everything(const World& world) {
  Bounds box = world.intersector.bounds();
  box.add(world.scene.camera.position);
  for (const Light& light : world.scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light.emitter)) box.add(point->position);
    if (const auto* spot = std::get_if<SpotLight>(&light.emitter)) box.add(spot->position);
    if (const auto* area = std::get_if<AreaLight>(&light.emitter)) {
      std::visit([&](const auto& shape) { box.add(shape.center); }, area->shape);
    }
  }
  return {(box.min + box.max) * 0.5, length(box.max - box.min) * 0.5};
}

// One target around the whole scene: every photon counts, whatever it meets first.
Targets target_everything(const World& world) {
  const BoundingSphere sphere = everything(world);
  const Vec3 reach{sphere.radius, sphere.radius, sphere.radius};
  Targets targets{.targets = {{0, sphere, {sphere.center - reach, sphere.center + reach}}},
                  .surroundings = {sphere, planes_of(world.scene)},
                  .warnings = {}};
  if (!targets.surroundings.planes.empty()) {
    targets.warnings.push_back("indirect light counts what falls within " + std::to_string(sphere.radius) +
                               " m of the middle of the scene; replace infinite planes by rectangles to cover more");
  }
  return targets;
}

// Let one photon walk, and store it wherever it comes after a diffuse surface.
void walk_photon(const PhotonPass& pass, PathState path, Stream stream, std::uint32_t index,
                 std::vector<PhotonRecord>& photons) {
  bool scattered = false;
  for (int steps = 0; steps < kMostSteps; ++steps) {
    const Arrival arrival = advance(pass, path);
    if (arrival.escaped) return;
    path.weight *= arrival.transmittance;
    if (scattered && can_be_diffuse(pass.scene.materials[arrival.event.material])) {
      photons.push_back(make_photon(pass.frame, arrival.hit.point, arrival.event.facing_normal, path.weight));
    }
    const StepSample sample = padded_4d(within(stream, static_cast<std::uint64_t>(steps)), index);
    const SampledLobe lobe = step(pass.scene, arrival, sample, Transported::flux, path);
    if (lobe == SampledLobe::none) return;
    scattered = scattered || lobe == SampledLobe::diffuse;
  }
}

std::vector<PhotonRecord> walk_photons(const PhotonPass& pass, const Chart& chart, const ChartBlock& block) {
  std::vector<PhotonRecord> photons;
  const double share = 1 / static_cast<double>(chart.count);
  const Stream stream = stream_of(pass.scene.settings.seed, Purpose::kDiffuseBounce, block.chart, block.half);
  const Stream bounces = within(stream, static_cast<std::uint64_t>(Purpose::kDiffuseBounce));
  for (std::uint64_t i = block.first; i < block.first + block.count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const auto u = sobol_4d(stream, index);
    const Emission emission = emit(chart, {unit_point(u[0], u[1]), unit_point(u[2], u[3])});
    if (is_black(emission.power)) continue;
    walk_photon(pass,
                {.ray = emission.ray,
                 .media = pass.intersector.media_at(emission.ray.origin),
                 .weight = emission.power * share},
                bounces, index, photons);
  }
  return photons;
}

}  // namespace

PhotonMaps make_indirect_maps(const World& world, const Workers& workers) {
  const Settings& settings = world.scene.settings;
  const Targets targets = target_everything(world);
  const std::vector<Chart> charts = make_charts(world.scene, targets, settings.photons / 2);
  const PhotonPass pass{world, {targets.surroundings.center}, targets.surroundings.radius};
  auto traced = trace_halves(plan_blocks(charts), "indirect_pass", workers,
                             [&](const ChartBlock& block) { return walk_photons(pass, charts[block.chart], block); });

  PhotonMaps maps;
  PhotonStatistics& statistics = maps.statistics;
  statistics.warnings = targets.warnings;
  for (const Chart& chart : charts) statistics.emitted += 2 * chart.count;
  for (const auto& half : traced.half) {
    for (const auto& photons : half) statistics.stored += photons.size();
  }
  statistics.trace_cpu_s = traced.cpu_s;
  statistics.sort_cpu_s = build_halves(workers, [&](std::uint64_t half) {
    maps.half[half] = std::make_unique<PhotonMap>(pass.frame, std::move(traced.half[half]),
                                                  kIndirectRadiusFactor * settings.gather_radius_m);
  });
  return maps;
}

}  // namespace vitrail
