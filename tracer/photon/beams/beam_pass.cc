#include "photon/beams/beam_pass.h"

#include "base/cpu_clock.h"
#include "base/parallel.h"

namespace vitrail {

void make_beams(const PhotonPass& pass, const std::vector<Chart>& charts, unsigned threads, Monitor& monitor,
                PhotonMaps& maps) {
  // Lay two lattices over each chart, apart by chance.
  std::vector<BeamLattice> lattices;
  struct BlockPlan {
    int half;
    std::size_t lattice;
    std::uint64_t block;
  };
  std::vector<BlockPlan> plan;
  for (std::uint64_t half = 0; half < 2; ++half) {
    for (std::size_t c = 0; c < charts.size(); ++c) {
      const Stream stream = stream_of(pass.scene.settings.seed, Purpose::kBeamLattice, c, half);
      lattices.emplace_back(pass, charts[c], stream);
      for (std::uint64_t b = 0; b < lattices.back().blocks(); ++b) {
        plan.push_back({static_cast<int>(half), lattices.size() - 1, b});
      }
    }
  }

  // Trace all blocks; each writes to a place of its own.
  std::vector<BeamBlock> blocks(plan.size());
  std::vector<double> cpu_s(plan.size());
  monitor.begin("photon_pass", plan.size());
  parallel_blocks(plan.size(), threads, [&](std::uint64_t b, unsigned) {
    if (monitor.interrupted()) return;
    const double start = thread_cpu_s();
    blocks[b] = lattices[plan[b].lattice].trace(plan[b].block);
    cpu_s[b] = thread_cpu_s() - start;
    monitor.advance(1);
  });

  // Add the ledgers in the order of the blocks.
  PhotonStatistics& statistics = maps.statistics;
  std::vector<BeamBlock> of_half[2];
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    statistics.ledger += blocks[b].ledger;
    statistics.at_discontinuities += blocks[b].at_discontinuities * 0.5;
    statistics.emitted += blocks[b].rays;
    statistics.stored += blocks[b].beams.size();
    statistics.trace_cpu_s += cpu_s[b];
    of_half[plan[b].half].push_back(std::move(blocks[b]));
  }

  // Build the trees of boxes, one thread each.
  double sort_cpu_s[2] = {0, 0};
  monitor.begin("photon_sort", 2);
  parallel_blocks(2, threads, [&](std::uint64_t half, unsigned) {
    if (monitor.interrupted()) of_half[half].clear();
    const double start = thread_cpu_s();
    maps.beams[half] = std::make_unique<BeamMap>(std::move(of_half[half]));
    sort_cpu_s[half] = thread_cpu_s() - start;
    monitor.advance(1);
  });
  statistics.sort_cpu_s += sort_cpu_s[0] + sort_cpu_s[1];
}

}  // namespace vitrail
