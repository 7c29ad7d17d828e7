#pragma once
/// Rays of one light on a lattice, and the beams between them.
///
/// Rays that light sends on its way next to each other land next to each other, as long as they meet the same faces.
/// Where they do not - at the edge of a lens, at the critical angle - the lattice is halved again and again, and the
/// light of what is left undecided at the end goes as photons. The error falls as the number of rays: with the square
/// of the cells.

#include <functional>
#include <memory>

#include "light/light.h"
#include "photon/beams/beam_tracer.h"
#include "photon/trace.h"

namespace vitrail {

/// Why the light of a chart cannot be followed as beams, which need one ray alone from each place of the light, and
/// smooth faces; nothing where it can.
const char* unfit_for_beams(const Scene& scene, const Chart& chart);

/// What decides whether beams are the better way for a light.
struct BeamPilot {
  double torn = 0;      // share of the light that lands between rays that part
  double landings = 0;  // per ray that meets the target: the sheets of beams that the light makes
};

class BeamLattice {
 public:
  /// About chart.count rays. `stream` draws how many cells a side exactly, so that two lattices are independent.
  BeamLattice(const PhotonPass& pass, const Chart& chart, Stream stream);

  /// Rows of cells that are traced together.
  std::uint64_t blocks() const;
  BeamBlock trace(std::uint64_t block) const;

  /// What a few blocks say of all; fewer, where what the first say is enough.
  BeamPilot pilot(const std::function<bool(const BeamPilot&)>& is_enough) const;

 private:
  const PhotonPass& pass_;
  const Chart& chart_;
  Stream stream_;
  LatticeShape shape_;
};

}  // namespace vitrail
