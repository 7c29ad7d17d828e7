#pragma once
/// The general strategy, one photon at a time: any shape, any nesting of glass, any coincidence of faces.

#include <vector>

#include "photon/band_combs.h"
#include "photon/landing.h"
#include "photon/photon_branches.h"
#include "photon/trace.h"

namespace vitrail {

/// A tree of paths: reflected and refracted light both go on from every interface, as far as `branches` follows them.
class PhotonTree {
 public:
  /// Where light ends goes into `landings`, the energy balance into `ledger`; both must outlive the tree.
  /// `stream` scrambles the random choices of rough faces, `combs` chooses bands.
  PhotonTree(const PhotonPass& pass, std::uint32_t target, Stream stream, LandingSink& landings, Ledger& ledger,
             const BandCombs& combs = {}, const PhotonBranches& branches = {})
      : pass_(pass),
        scene_(pass.scene),
        target_(target),
        stream_(stream),
        landings_(landings),
        ledger_(ledger),
        combs_(combs),
        branches_(branches) {}

  /// Follow every branch to its end. A photon that has not bounced counts only if it meets the target first.
  void follow(const LightVertex& start);

 private:
  // In these the weight of the vertex is the flux that arrives.
  void arrive(LightVertex& photon, const Arrival& arrival);
  void split_bands(LightVertex& photon, const Arrival& arrival);
  void scatter(const LightVertex& photon, const Arrival& arrival, const Interaction& event);
  void divide(const LightVertex& photon, const Arrival& arrival, const Interaction& event);
  void send_on(const LightVertex& photon, const Arrival& arrival, const Interaction& event, DividedFlux flux);
  void send(const LightVertex& from, const Arrival& arrival, const Branch& branch, Rgb flux, double share);

  const PhotonPass& pass_;
  const Scene& scene_;
  std::uint32_t target_;
  Stream stream_;
  LandingSink& landings_;
  Ledger& ledger_;
  BandCombs combs_;
  PhotonBranches branches_;
  std::vector<LightVertex> pending_;
};

}  // namespace vitrail
