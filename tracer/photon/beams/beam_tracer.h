#pragma once
/// Puts beams between the rays of one block of a lattice, and sends as photons what no beam holds.

#include <array>
#include <optional>
#include <vector>

#include "base/random.h"
#include "photon/beams/lattice_rays.h"

namespace vitrail {

/// How a lattice lies over a chart.
struct LatticeShape {
  std::uint32_t cells;  // along each side of the chart, an even number
  int halvings;         // of a cell whose rays part

  std::uint32_t pieces_per_cell() const { return 1u << halvings; }
  std::uint64_t pieces() const { return static_cast<std::uint64_t>(cells) << halvings; }
};

class BeamTracer {
 public:
  /// At most about `most_rays`. `stream` draws the places of photons.
  BeamTracer(const PhotonPass& pass, const Chart& chart, const LatticeShape& shape, std::uint64_t most_rays,
             Stream stream, BeamBlock& block);

  /// The beams and photons of the cell in column i and row j.
  void cell(std::uint32_t i, std::uint32_t j);

 private:
  using Triangle = std::array<std::uint32_t, 3>;
  /// A signature that has its beam, and the triangle of that.
  struct Held {
    PathSignature signature;
    Triangle between;
    std::uint32_t beam;  // of the block
  };

  void whole_triangle(const Triangle& t);
  void triangle(const Triangle& t, int halvings);
  double hold(const Triangle& t);
  bool put_beam(const Triangle& t, PathSignature signature);
  bool is_wide(const Beam& beam) const;
  void enter_in_ledger(const Triangle& t);
  void look_into(const Triangle& t);
  void send_photons(const Triangle& t);
  void correct_beams(std::uint32_t ray, double each);
  void correct_beams(double x, double y, double each);
  void correct(const Held& beam, Rgb missing, double each);
  void apply_corrections();
  std::array<double, 2> place_within(const Triangle& t);
  const Held* held(PathSignature signature) const;
  double share_of(const Triangle& t) const;
  Rgb power_of(std::uint32_t corner) const;
  Rgb power_between(const Held& held, double x, double y) const;

  const PhotonPass& pass_;
  const Chart& chart_;
  LatticeShape shape_;
  std::uint64_t most_rays_;
  Stream stream_;
  BeamBlock& block_;
  LatticeRays rays_;
  double finest_share_;              // of the chart, a triangle after all halvings
  std::vector<Held> held_;           // by beams of the triangle at hand or of those around it
  std::vector<double> corrections_;  // of the power of the triangle's beams, W, from `first_beam_` on
  std::uint32_t first_beam_ = 0;
  std::uint64_t triangles_ = 0;
  std::uint32_t drawn_ = 0;
};

}  // namespace vitrail
