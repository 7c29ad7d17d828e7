#include "photon/beams/beam_pass.h"

#include "photon/halves.h"

namespace vitrail {
namespace {

/// A few rows of one lattice.
struct LatticeBlock {
  std::uint64_t half;
  std::size_t lattice;
  std::uint64_t block;
};

}  // namespace

void make_beams(const PhotonPass& pass, const std::vector<Chart>& charts, const Workers& workers, PhotonMaps& maps,
                PhotonBlocks& photons) {
  // Lay two lattices over each chart, apart by chance.
  std::vector<BeamLattice> lattices;
  std::vector<LatticeBlock> plan;
  for (std::uint64_t half = 0; half < 2; ++half) {
    for (std::size_t c = 0; c < charts.size(); ++c) {
      lattices.emplace_back(pass, charts[c], stream_of(pass.scene.settings.seed, Purpose::kBeamLattice, c, half));
      for (std::uint64_t b = 0; b < lattices.back().blocks(); ++b) plan.push_back({half, lattices.size() - 1, b});
    }
  }
  auto traced = trace_halves(plan, "photon_pass", workers, [&](const LatticeBlock& planned) {
    return lattices[planned.lattice].trace(planned.block);
  });

  // Add the ledgers in the order of the blocks.
  PhotonStatistics& statistics = maps.statistics;
  for (std::size_t half = 0; half < 2; ++half) {
    for (BeamBlock& block : traced.half[half]) {
      statistics.ledger += block.ledger;
      statistics.remainder.as_photons += block.remainder.as_photons * 0.5;
      statistics.remainder.unseen += block.remainder.unseen * 0.5;
      statistics.emitted += block.rays;
      statistics.stored += block.beams.size() + block.photons.size();
      photons[half].push_back(std::move(block.photons));
    }
  }
  statistics.trace_cpu_s += traced.cpu_s;
  statistics.sort_cpu_s += build_halves(
      workers, [&](std::uint64_t half) { maps.beams[half] = std::make_unique<BeamMap>(std::move(traced.half[half])); });
}

}  // namespace vitrail
