#pragma once
/// Follow photons from a light through mirrors and glass to the diffuse surfaces where they are stored.

#include "base/random.h"
#include "light/light.h"
#include "photon/landing.h"
#include "photon/ledger.h"
#include "photon/photon_map.h"

namespace vitrail {

/// A branch below this share of the photon's power where it began lives by chance. Where every branch is followed it is
/// cut off and counted as truncated.
inline constexpr double kLeastPhotonShare = 1e-4;

/// What one block of photons leaves behind.
struct PhotonBlock {
  std::vector<PhotonRecord> photons;
  Ledger ledger;
  std::uint64_t divisions = 0;  // how often a face divided a photon of the wave: what the work grows with
};

/// Keeps every landing as a photon of a block.
class PhotonStore : public LandingSink {
 public:
  PhotonStore(const PhotonFrame& frame, PhotonBlock& block) : frame_(frame), block_(block) {}
  void land(const Landing& landing) override {
    block_.photons.push_back(make_photon(frame_, landing.position, landing.normal, landing.flux));
  }

 private:
  PhotonFrame frame_;
  PhotonBlock& block_;
};

/// Everything that stays the same over a photon pass.
struct PhotonPass : World {
  PhotonFrame frame;
  double radius_m = 0;  // of everything finite, about the frame's origin
};

/// How photons are followed: `automatic` takes the wave where it suits the scene. Both strategies obey the same physics
/// and agree to rounding.
enum class Strategy { automatic, tree };

/// Emit photons first .. first + count of a chart with a scrambling, and follow each through its branches: reflected
/// and refracted light both go on, in exact shares, while they carry much of the photon; of weaker branches some by
/// chance, as PhotonBranches says. The ledger closes photon by photon. A photon is stored on every surface that can be
/// diffuse, after at least one specular bounce [S section 4].
PhotonBlock trace_photons(const PhotonPass& pass, const Chart& chart, Stream stream, std::uint64_t first,
                          std::uint64_t count, Strategy strategy = Strategy::automatic);

}  // namespace vitrail
