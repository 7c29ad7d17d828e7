#include "photon/photon_branches.h"

#include <algorithm>

namespace vitrail {
namespace {

/// Of a photon at its first face, and as much more at each face behind it, up to the most. The mirror of a face of
/// usual glass carries more than the first: first reflections have no noise of chance. Decision 44 has what others
/// cost.
constexpr double kLeastShare = 0.03, kMostShare = 0.3;

double least_share(const Depth& depth) { return std::min(kMostShare, kLeastShare * (1 + depth.faces())); }

}  // namespace

WaysOn PhotonBranches::choose(const DividingPhoton& photon, const DividedFlux& flux) const {
  const std::array<double, 2> carried{largest_channel(flux[0]), largest_channel(flux[1])};
  const double sum = carried[0] + carried[1];
  WaysOn ways;
  if (!(sum > 0)) return ways;
  bool any_faint = false;
  for (std::size_t way = 0; way < 2; ++way) {
    const bool faint = carried[way] < photon.least;
    ways.share[way] = photon.share * (carried[way] / sum);
    ways.factor[way] = carried[way] > 0 && (by_chance_ || !faint) ? 1 : 0;
    any_faint = any_faint || (faint && carried[way] > 0);
  }
  if (!by_chance_) return ways;
  const double least = least_share(photon.depth);
  if (any_faint || leaves_to_chance(ways.share, least)) draw(photon, carried, least, ways);
  return ways;
}

void PhotonBranches::draw(const DividingPhoton& photon, const std::array<double, 2>& carried, double least,
                          WaysOn& ways) const {
  // Faces of one path have different depths: its choices are independent.
  const auto face = static_cast<std::uint64_t>(64 * photon.depth.reflections + photon.depth.transmissions);
  const auto chance = padded_2d(within(stream_, face), photon.index);
  ways.factor = choose_branches(ways.share, least, chance[0]);
  for (std::size_t way = 0; way < 2; ++way) {
    ways.share[way] *= ways.factor[way];
    const double flux = carried[way] * ways.factor[way];
    if (flux > 0 && flux < photon.least) ways.factor[way] *= chance[1] * photon.least < flux ? photon.least / flux : 0;
  }
}

}  // namespace vitrail
