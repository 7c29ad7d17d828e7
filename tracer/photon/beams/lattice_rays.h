#pragma once
/// The rays of one block of a lattice: each is followed through all its branches once, when it is first asked for.

#include <unordered_map>

#include "photon/beams/beam.h"
#include "photon/photon_tree.h"

namespace vitrail {

/// A place on a surface that a ray reaches.
struct RayEnd {
  PathSignature signature;
  std::uint32_t corner;  // of the block
  bool far;              // too far away to be seen
};

/// A ray of a lattice, by its place in the unit square of the chart.
struct LatticeRay {
  std::uint32_t a, b;  // in the finest pieces of the cells
  double x, y;
  std::uint32_t first_end, end_count;
  Ledger ledger;  // as if the whole chart were like this ray
};

class LatticeRays : private LandingSink {
 public:
  /// `pieces` along each side of the chart. Corners go into `block`, and the number of rays.
  LatticeRays(const PhotonPass& pass, const Chart& chart, std::uint64_t pieces, BeamBlock& block)
      : pass_(pass),
        chart_(chart),
        pieces_(static_cast<double>(pieces)),
        block_(block),
        tree_(pass, chart.target, Stream{0}, *this, ledger_) {}

  /// The index of the ray at a place, followed if it is new.
  std::uint32_t at(std::uint32_t a, std::uint32_t b);

  /// The index of the ray in the middle between two.
  std::uint32_t between(std::uint32_t p, std::uint32_t q) {
    return at((rays_[p].a + rays_[q].a) / 2, (rays_[p].b + rays_[q].b) / 2);
  }
  const LatticeRay& operator[](std::uint32_t index) const { return rays_[index]; }

  /// Where a ray ends, in the order of the signatures: end k for k below its end_count.
  const RayEnd& end(const LatticeRay& ray, std::uint32_t k) const { return ends_[ray.first_end + k]; }
  /// Nothing if no branch of the ray has the signature.
  const RayEnd* end_of(std::uint32_t ray, PathSignature signature) const;

  /// Follow a ray from any place of the unit square; `landings` and `ledger` are then its own.
  void follow(double x, double y);
  const std::vector<Landing>& landings() const { return landings_; }
  const Ledger& ledger() const { return ledger_; }

 private:
  void land(const Landing& landing) override { landings_.push_back(landing); }
  LatticeRay followed(std::uint32_t a, std::uint32_t b);

  const PhotonPass& pass_;
  const Chart& chart_;
  double pieces_;
  BeamBlock& block_;
  Ledger ledger_;
  PhotonTree tree_;
  std::vector<Landing> landings_;
  std::vector<LatticeRay> rays_;
  std::vector<RayEnd> ends_;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;  // of rays, by their place
};

}  // namespace vitrail
