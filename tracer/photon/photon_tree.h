#pragma once
/// The general way to follow one photon: any shape, any nesting of glass, any coincidence of faces.

#include <vector>

#include "photon/flight.h"
#include "photon/trace.h"

namespace vitrail {

class PhotonTree {
 public:
  /// Books and photons go into `block`, which must outlive the tree.
  /// `stream` scrambles the random choices of rough faces.
  PhotonTree(const PhotonPass& pass, std::uint32_t target, Stream stream, PhotonBlock& block)
      : pass_(pass), scene_(pass.scene), target_(target), stream_(stream), block_(block) {}

  /// Follow every branch to its end. A flight that has not bounced counts only if it meets the target first.
  void follow(const Flight& flight);

 private:
  void arrive(const Flight& flight, const Arrival& arrival);
  void split_bands(Flight flight, const Arrival& arrival, Rgb flux);
  void go_on(const Flight& flight, const Arrival& arrival, const Interaction& event, Rgb flux);
  void meet(const Flight& flight, const Arrival& arrival, const Interaction& event, Rgb flux);
  void send(const Flight& from, const Arrival& arrival, const Branch& branch, Rgb flux, int reflections,
            int transmissions);

  const PhotonPass& pass_;
  const Scene& scene_;
  std::uint32_t target_;
  Stream stream_;
  PhotonBlock& block_;
  std::vector<Flight> pending_;
};

}  // namespace vitrail
