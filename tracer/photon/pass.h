#pragma once
/// The whole light side: charts, blocks of photons on all threads, and one sorted map for each half.

#include <memory>

#include "base/monitor.h"
#include "photon/beams/beam_map.h"
#include "photon/trace.h"

namespace vitrail {

struct PhotonStatistics {
  Ledger ledger;           // mean of the two halves, each of which carries the whole power
  Rgb at_discontinuities;  // W, of what the ledger says is truncated: it fell between beams
  std::uint64_t emitted = 0, stored = 0;
  double trace_cpu_s = 0, sort_cpu_s = 0;
  std::vector<std::string> warnings;
};

/// Two maps from independent scramblings of the same light. Each alone estimates the caustic; their difference is
/// noise. With the solver `beams` each light is in one of the two kinds of map, else all are in `half`.
struct PhotonMaps {
  std::unique_ptr<PhotonMap> half[2];
  std::unique_ptr<BeamMap> beams[2];
  PhotonStatistics statistics;

  /// What all lights bring to a place, W/m2, by the maps of one half.
  Rgb irradiance(int which, const GatherQuery& query) const {
    Rgb sum;
    if (half[which]) sum += half[which]->irradiance(query);
    if (beams[which]) sum += beams[which]->irradiance(query);
    return sum;
  }
};

/// Whether the scene's solver is `beams`: light from places and directions, through smooth faces, as beams; the rest as
/// photons.
bool takes_beams(const Scene& scene);

/// Emit settings.photons, half of them into each map. Empty maps if the monitor interrupts.
PhotonMaps make_photon_maps(const Scene& scene, const Intersector& intersector, unsigned threads, Monitor& monitor);

/// How often a photon is stored, from a few hundred of every chart. Faces that divide light make this more than 1.
double stored_per_photon(const Scene& scene, const Intersector& intersector);

/// Peak bytes of the pass if each photon is stored so many times.
std::uint64_t predicted_photon_bytes(std::uint64_t photons, double stored_per_photon);

}  // namespace vitrail
