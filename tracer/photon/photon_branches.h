#pragma once
/// Which ways a photon takes where light divides: both while they carry much of it, by chance some that carry little
/// (Russian roulette).

#include "base/random.h"
#include "base/vec3.h"
#include "material/branch_choice.h"
#include "scene/scene.h"

namespace vitrail {

/// The flux of each of two ways on, W; black for a way that does not exist.
using DividedFlux = std::array<Rgb, 2>;

/// A photon where it divides.
struct DividingPhoton {
  double share = 1;         // of the photon that left the light, by how it divided: absorption and tints leave it alone
  double least = 0;         // W; faint light lives by chance, or is cut off where every way is followed
  std::uint32_t index = 0;  // in its chart
  Depth depth;
};

/// What becomes of the ways of a photon.
struct WaysOn {
  CarriedShares share{};  // as DividingPhoton::share
  BranchFactors factor{};
};

class PhotonBranches {
 public:
  /// Every way down to the least flux.
  PhotonBranches() = default;
  /// Both ways from some share of the photon on, and some of the weaker ones by numbers of chance out of `stream`.
  explicit PhotonBranches(Stream stream)
      : by_chance_(true), stream_(within(stream, static_cast<std::uint64_t>(Purpose::kRoulette))) {}

  /// The mean of every factor over chance is 1, unless every way is followed: then 0 cuts off what is faint.
  WaysOn choose(const DividingPhoton& photon, const DividedFlux& flux) const;
  bool follow_every_way() const { return !by_chance_; }

 private:
  void draw(const DividingPhoton& photon, const std::array<double, 2>& carried, double least, WaysOn& ways) const;

  bool by_chance_ = false;
  Stream stream_{};
};

}  // namespace vitrail
