#include "photon/pass.h"

#include <algorithm>

#include "base/cpu_clock.h"
#include "base/parallel.h"
#include "photon/beams/beam_pass.h"

namespace vitrail {
namespace {

// A power of two, so that each block of a chart is a net of its own.
constexpr std::uint64_t kPhotonsPerBlock = 8192;

struct BlockPlan {
  int half;
  std::uint32_t chart;
  std::uint64_t first, count;
};

std::vector<BlockPlan> plan_blocks(const std::vector<Chart>& charts) {
  std::vector<BlockPlan> plan;
  for (int half = 0; half < 2; ++half) {
    for (std::uint32_t c = 0; c < charts.size(); ++c) {
      for (std::uint64_t first = 0; first < charts[c].count; first += kPhotonsPerBlock) {
        plan.push_back({half, c, first, std::min(kPhotonsPerBlock, charts[c].count - first)});
      }
    }
  }
  return plan;
}

}  // namespace

bool takes_beams(const Scene& scene) { return scene.settings.solver == "beams"; }

PhotonMaps make_photon_maps(const Scene& scene, const Intersector& intersector, unsigned threads, Monitor& monitor) {
  PhotonMaps maps;
  PhotonStatistics& statistics = maps.statistics;
  const Targets targets = find_targets(scene, intersector);
  statistics.warnings = targets.warnings;
  std::vector<Chart> charts = make_charts(scene, targets, scene.settings.photons / 2);
  const PhotonPass pass{scene, intersector, {targets.surroundings.center}, targets.surroundings.radius};

  // Leave to beams what they can do.
  if (takes_beams(scene)) {
    const auto rest = std::stable_partition(charts.begin(), charts.end(),
                                            [&](const Chart& chart) { return suits_beams(scene, chart); });
    make_beams(pass, {charts.begin(), rest}, threads, monitor, maps);
    charts.erase(charts.begin(), rest);
  }

  // Trace all blocks; each writes to a place of its own, so the order of the work is of no consequence.
  const std::vector<BlockPlan> plan = plan_blocks(charts);
  std::vector<PhotonBlock> blocks(plan.size());
  std::vector<double> cpu_s(plan.size());
  monitor.begin("photon_pass", plan.size());
  parallel_blocks(plan.size(), threads, [&](std::uint64_t b, unsigned) {
    if (monitor.interrupted()) return;
    const double start = thread_cpu_s();
    const BlockPlan& todo = plan[b];
    const std::uint64_t half = static_cast<std::uint64_t>(todo.half);
    const Stream stream = stream_of(scene.settings.seed, Purpose::kEmissionPosition, todo.chart, half);
    blocks[b] = trace_photons(pass, charts[todo.chart], stream, todo.first, todo.count);
    cpu_s[b] = thread_cpu_s() - start;
    monitor.advance(1);
  });

  // Add the ledgers in the order of the blocks.
  std::vector<std::vector<PhotonRecord>> records[2];
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    statistics.ledger += blocks[b].ledger;
    statistics.emitted += plan[b].count;
    statistics.stored += blocks[b].photons.size();
    statistics.trace_cpu_s += cpu_s[b];
    records[plan[b].half].push_back(std::move(blocks[b].photons));
  }
  statistics.ledger = statistics.ledger.scaled(0.5);
  if (plan.empty() && takes_beams(scene)) return maps;

  // Sort each half, one thread each.
  double sort_cpu_s[2] = {0, 0};
  monitor.begin("photon_sort", 2);
  parallel_blocks(2, threads, [&](std::uint64_t half, unsigned) {
    if (monitor.interrupted()) records[half].clear();
    const double start = thread_cpu_s();
    maps.half[half] = std::make_unique<PhotonMap>(pass.frame, std::move(records[half]), scene.settings.gather_radius_m);
    sort_cpu_s[half] = thread_cpu_s() - start;
    monitor.advance(1);
  });
  statistics.sort_cpu_s += sort_cpu_s[0] + sort_cpu_s[1];
  return maps;
}

double stored_per_photon(const Scene& scene, const Intersector& intersector) {
  constexpr std::uint64_t kPilot = 512;
  const Targets targets = find_targets(scene, intersector);
  const std::vector<Chart> charts = make_charts(scene, targets, scene.settings.photons / 2);
  const PhotonPass pass{scene, intersector, {targets.surroundings.center}, targets.surroundings.radius};
  double stored = 0, emitted = 0;
  for (const Chart& chart : charts) {
    const std::uint64_t count = std::min(kPilot, chart.count);
    const Stream stream = stream_of(scene.settings.seed, Purpose::kPilot);
    const PhotonBlock block = trace_photons(pass, chart, stream, 0, count);
    const double each_stands_for = static_cast<double>(chart.count) / static_cast<double>(count);
    stored += each_stands_for * static_cast<double>(block.photons.size());
    emitted += static_cast<double>(chart.count);
  }
  return emitted > 0 ? stored / emitted : 0;
}

std::uint64_t predicted_photon_bytes(std::uint64_t photons, double stored_per_photon) {
  const auto stored = static_cast<std::uint64_t>(stored_per_photon * static_cast<double>(photons));
  return 2 * PhotonMap::predicted_bytes(stored / 2);
}

}  // namespace vitrail
