#pragma once
/// Rays of one light on a lattice, and the beams between them.
///
/// Rays that light sends on its way next to each other land next to each other, as long as they meet the same faces.
/// Where they do not - at the edge of a lens, at the critical angle - the lattice is halved again and again, and what
/// is left undecided at the end is counted as truncated. The error falls as the number of rays: with the square of the
/// cells.

#include <memory>

#include "light/light.h"
#include "photon/beams/beam.h"
#include "photon/trace.h"

namespace vitrail {

/// Whether the light of a chart can be followed as beams: from each place of the light one ray alone, through smooth
/// faces.
bool suits_beams(const Scene& scene, const Chart& chart);

class BeamLattice {
 public:
  /// About chart.count rays. `stream` draws how many cells a side exactly, so that two lattices are independent.
  BeamLattice(const PhotonPass& pass, const Chart& chart, Stream stream);

  /// Rows of cells that are traced together.
  std::uint64_t blocks() const;
  BeamBlock trace(std::uint64_t block) const;

 private:
  const PhotonPass& pass_;
  const Chart& chart_;
  std::uint32_t cells_;  // along each side of the chart, an even number
  int halvings_;         // of a cell whose rays part

  friend class BeamTracer;
};

}  // namespace vitrail
