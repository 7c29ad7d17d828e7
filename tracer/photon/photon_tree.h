#pragma once
/// The general way to follow one photon: any shape, any nesting of glass, any coincidence of faces.

#include <vector>

#include "photon/landing.h"
#include "photon/trace.h"

namespace vitrail {

class PhotonTree {
 public:
  /// Where light ends goes into `landings`, the energy balance into `ledger`; both must outlive the tree.
  /// `stream` scrambles the random choices of rough faces.
  PhotonTree(const PhotonPass& pass, std::uint32_t target, Stream stream, LandingSink& landings, Ledger& ledger)
      : pass_(pass), scene_(pass.scene), target_(target), stream_(stream), landings_(landings), ledger_(ledger) {}

  /// Follow every branch to its end. A flight that has not bounced counts only if it meets the target first.
  void follow(const Flight& flight);

 private:
  void arrive(const Flight& flight, const Arrival& arrival);
  void split_bands(Flight flight, const Arrival& arrival, Rgb flux);
  void go_on(const Flight& flight, const Arrival& arrival, const Interaction& event, Rgb flux);
  void meet(const Flight& flight, const Arrival& arrival, const Interaction& event, Rgb flux);
  void send(const Flight& from, const Arrival& arrival, const Branch& branch, Rgb flux);

  const PhotonPass& pass_;
  const Scene& scene_;
  std::uint32_t target_;
  Stream stream_;
  LandingSink& landings_;
  Ledger& ledger_;
  std::vector<Flight> pending_;
};

}  // namespace vitrail
