#pragma once
/// The beams of several charts, on all threads, and one tree of them for each half.

#include <vector>

#include "base/workers.h"
#include "photon/beams/beam_lattice.h"
#include "photon/photon_maps.h"

namespace vitrail {

/// Adds to the statistics of `maps`: a ray counts as a photon emitted, a beam as one stored, and the ledger is the sum
/// of both halves. No maps if the monitor interrupts.
void make_beams(const PhotonPass& pass, const std::vector<Chart>& charts, const Workers& workers, PhotonMaps& maps);

}  // namespace vitrail
