#pragma once
/// The beams of several charts, on all threads, and one tree of them for each half.

#include <array>
#include <vector>

#include "base/workers.h"
#include "photon/beams/beam_lattice.h"
#include "photon/photon_maps.h"

namespace vitrail {

/// Blocks of photons for each half.
using PhotonBlocks = std::array<std::vector<std::vector<PhotonRecord>>, 2>;

/// Adds to the statistics of `maps`: a ray counts as a photon emitted, a beam as one stored, and the ledger is the sum
/// of both halves. No maps if the monitor interrupts. Adds the light that no beam holds to `photons`.
void make_beams(const PhotonPass& pass, const std::vector<Chart>& charts, const Workers& workers, PhotonMaps& maps,
                PhotonBlocks& photons);

}  // namespace vitrail
