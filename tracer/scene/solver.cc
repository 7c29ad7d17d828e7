#include "scene/solver.h"

#include <stdexcept>

namespace vitrail {

const char* name_of(Solver solver) {
  switch (solver) {
    case Solver::automatic:
      return "auto";
    case Solver::photon_map:
      return "photon_map";
    case Solver::light_bins:
      return "light_bins";
    case Solver::beams:
      return "beams";
  }
  throw std::logic_error("no such solver");
}

Solver resolve(Solver asked, std::uint64_t photons, double pixels) {
  if (asked != Solver::automatic) return asked;
  return static_cast<double>(photons) >= kPhotonsForBins * pixels ? Solver::light_bins : Solver::photon_map;
}

}  // namespace vitrail
