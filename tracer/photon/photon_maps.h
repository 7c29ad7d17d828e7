#pragma once
/// What a photon pass leaves behind: maps to be asked for irradiance, in two independent halves, and what it cost.

#include <memory>
#include <string>

#include "photon/beams/beam_map.h"
#include "photon/ledger.h"
#include "photon/photon_map.h"

namespace vitrail {

struct PhotonStatistics {
  Ledger ledger;           // mean of the two halves, each of which carries the whole power; caustics only
  Rgb at_discontinuities;  // W, the part of what the ledger says is truncated that fell between beams
  std::uint64_t emitted = 0, stored = 0;
  double trace_cpu_s = 0, sort_cpu_s = 0;
  std::vector<std::string> warnings;
};

/// Two maps from independent scramblings of the same light. Each alone estimates the irradiance; their difference is
/// noise. With the solver `beams` each light is in one of the two kinds of map, else all are in `half`.
struct PhotonMaps {
  std::unique_ptr<PhotonMap> half[2];
  std::unique_ptr<BeamMap> beams[2];
  PhotonStatistics statistics;

  /// What all lights bring to a place, W/m2, by the maps of one half; nothing where there are none.
  Rgb irradiance(int which, const GatherQuery& query) const {
    Rgb sum;
    if (half[which]) sum += half[which]->irradiance(query);
    if (beams[which]) sum += beams[which]->irradiance(query);
    return sum;
  }
};

}  // namespace vitrail
