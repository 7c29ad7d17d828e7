#include "photon/indirect.h"

#include <algorithm>

#include "base/cpu_clock.h"
#include "base/parallel.h"
#include "photon/flight.h"
#include "photon/walk.h"

namespace vitrail {
namespace {

constexpr std::uint64_t kPhotonsPerBlock = 8192;

// A closed white room would keep a photon for ever.
constexpr int kMostSteps = 1000;

// A sphere around everything finite, the camera and the lamps, so that lamps in the scene shine in every direction.
BoundingSphere everything(const Scene& scene, const Intersector& intersector) {
  Bounds box = intersector.bounds();
  box.add(scene.camera.position);
  for (const Light& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light.emitter)) box.add(point->position);
    if (const auto* spot = std::get_if<SpotLight>(&light.emitter)) box.add(spot->position);
    if (const auto* area = std::get_if<AreaLight>(&light.emitter)) {
      std::visit([&](const auto& shape) { box.add(shape.center); }, area->shape);
    }
  }
  return {(box.min + box.max) * 0.5, length(box.max - box.min) * 0.5};
}

struct IndirectBlock {
  std::vector<PhotonRecord> photons;
  double cpu_s = 0;
};

// Let one photon walk, and store it wherever it comes after a diffuse surface.
void walk_photon(const PhotonPass& pass, Walk walk, Stream stream, std::uint32_t index, IndirectBlock& block) {
  bool scattered = false;
  for (int steps = 0; steps < kMostSteps; ++steps) {
    const Arrival arrival = advance(pass.scene, pass.intersector, walk.ray, walk.departures, walk.media, walk.band);
    if (arrival.escaped) return;
    walk.weight *= arrival.transmittance;
    if (scattered && can_be_diffuse(pass.scene.materials[arrival.event.material])) {
      block.photons.push_back(make_photon(pass.frame, arrival.hit.point, arrival.event.facing_normal, walk.weight));
    }
    const StepSample sample = padded_4d(within(stream, static_cast<std::uint64_t>(steps)), index);
    const SampledLobe way = step(pass.scene, arrival, sample, Travels::light, walk);
    if (way == SampledLobe::none) return;
    scattered = scattered || way == SampledLobe::diffuse;
  }
}

IndirectBlock walk_photons(const PhotonPass& pass, const Chart& chart, Stream stream, std::uint64_t first,
                           std::uint64_t count) {
  IndirectBlock block;
  const double start = thread_cpu_s(), share = 1 / static_cast<double>(chart.count);
  const Stream on_the_way = within(stream, static_cast<std::uint64_t>(Purpose::kDiffuseBounce));
  for (std::uint64_t i = first; i < first + count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const auto u = sobol_4d(stream, index);
    const Emission emission = emit(chart, {unit_point(u[0], u[1]), unit_point(u[2], u[3])});
    if (is_black(emission.power)) continue;
    const MediumSet media = pass.intersector.media_at(emission.ray.origin);
    walk_photon(pass, {emission.ray, {}, media, emission.power * share}, on_the_way, index, block);
  }
  block.cpu_s = thread_cpu_s() - start;
  return block;
}

}  // namespace

IndirectMaps make_indirect_maps(const Scene& scene, const Intersector& intersector, unsigned threads,
                                Monitor& monitor) {
  IndirectMaps maps;
  const BoundingSphere sphere = everything(scene, intersector);
  const Vec3 reach{sphere.radius, sphere.radius, sphere.radius};
  const Targets targets{{{0, sphere, {sphere.center - reach, sphere.center + reach}}}, {sphere, planes_of(scene)}, {}};
  if (!targets.surroundings.planes.empty()) {
    maps.warnings.push_back("indirect light counts what falls within " + std::to_string(sphere.radius) +
                            " m of the middle of the scene; replace infinite planes by rectangles to cover more");
  }
  const std::vector<Chart> charts = make_charts(scene, targets, scene.settings.photons / 2);
  const PhotonPass pass{scene, intersector, {sphere.center}};

  // One block after the other within a half, on all threads.
  for (std::uint64_t half = 0; half < 2; ++half) {
    std::vector<std::vector<PhotonRecord>> records;
    for (std::uint32_t c = 0; c < charts.size(); ++c) {
      const std::uint64_t blocks = (charts[c].count + kPhotonsPerBlock - 1) / kPhotonsPerBlock;
      const std::size_t place = records.size();
      records.resize(place + blocks);
      std::vector<double> cpu_s(blocks);
      monitor.begin("indirect_pass", blocks);
      parallel_blocks(blocks, threads, [&](std::uint64_t b, unsigned) {
        if (monitor.interrupted()) return;
        const std::uint64_t first = b * kPhotonsPerBlock;
        const Stream stream = stream_of(scene.settings.seed, Purpose::kDiffuseBounce, c, half);
        IndirectBlock block =
            walk_photons(pass, charts[c], stream, first, std::min(kPhotonsPerBlock, charts[c].count - first));
        records[place + b] = std::move(block.photons);
        cpu_s[b] = block.cpu_s;
        monitor.advance(1);
      });
      maps.emitted += charts[c].count;
      for (double s : cpu_s) maps.trace_cpu_s += s;
    }
    const double start = thread_cpu_s();
    maps.half[half] = std::make_unique<PhotonMap>(pass.frame, std::move(records),
                                                  kIndirectRadiusFactor * scene.settings.gather_radius_m);
    maps.stored += maps.half[half]->size();
    maps.sort_cpu_s += thread_cpu_s() - start;
  }
  return maps;
}

}  // namespace vitrail
