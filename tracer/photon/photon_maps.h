#pragma once
/// What a photon pass leaves behind: maps to be asked for irradiance, in two independent halves, and what it cost.

#include <memory>
#include <string>

#include "photon/beams/beam_lattice.h"
#include "photon/beams/beam_map.h"
#include "photon/ledger.h"
#include "photon/photon_map.h"

namespace vitrail {

/// How the light of one lamp reaches its way through one object, and why.
struct LightRoute {
  std::uint32_t light, target;
  bool by_beams;
  BeamPilot pilot;  // nothing if beams were not tried
  const char* because;
};

struct PhotonStatistics {
  Ledger ledger;            // mean of the two halves, each of which carries the whole power; caustics only
  BeamRemainder remainder;  // of the light that went into beams, mean of the two halves
  std::uint64_t emitted = 0, stored = 0;
  double trace_cpu_s = 0, sort_cpu_s = 0;
  std::vector<LightRoute> routes;      // caustics only
  Solver solver = Solver::photon_map;  // the one taken, after the pilots
  std::vector<std::string> warnings;
};

/// Two maps from independent scramblings of the same light. Each alone estimates the irradiance; their difference is
/// noise. With the solver `beams` `half` has the lights that beams cannot do, and what no beam holds of the others.
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
