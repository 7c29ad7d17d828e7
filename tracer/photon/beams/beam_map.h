#pragma once
/// All beams of one half, to be asked for the irradiance at a place: a tree of boxes over them.

#include <array>
#include <cstddef>
#include <vector>

#include "photon/beams/beam.h"
#include "photon/photon_map.h"

namespace vitrail {

class BeamMap {
 public:
  /// Take the beams of all blocks, in block order.
  explicit BeamMap(std::vector<BeamBlock> blocks);

  /// Irradiance per channel, W/m2: the sum over the beams that cover the place on that side, each with the flux between
  /// its rays over the area that they enclose, and its corners' powers interpolated.
  Rgb irradiance(const GatherQuery& query) const;

  /// Peak bytes while a map of so many corners is made: two beams a corner, and as much again for those at
  /// discontinuities.
  static std::size_t predicted_bytes(std::size_t corners);

  std::size_t size() const { return beams_.size(); }
  const Beam& beam(std::size_t index) const { return beams_[index]; }
  const BeamCorner& corner(std::uint32_t index) const { return corners_[index]; }

  /// The corners of a beam, its longest side, and how far from their plane its surface may be, metres.
  struct Sides {
    Vec3 p, q, r;
    double longest, room;
  };
  Sides sides_of(const Beam& beam) const;

 private:
  /// Bounds in floats, rounded outwards.
  struct Box {
    std::array<float, 3> low, high;
    bool holds(const std::array<double, 3>& p) const {
      for (int a = 0; a < 3; ++a) {
        if (p[a] < low[a] || p[a] > high[a]) return false;
      }
      return true;
    }
    void include(const Box& other);
  };
  Box box_of(const Beam& beam) const;
  void sort_along_curve();
  void build_boxes();
  Rgb irradiance_of(const Beam& beam, const GatherQuery& query) const;

  std::vector<BeamCorner> corners_;
  std::vector<Beam> beams_;  // neighbours in space are neighbours here
  std::vector<Box> boxes_;  // a complete binary tree: the children of k are 2k and 2k + 1, leaves hold a few beams each
  std::size_t leaves_ = 0;  // a power of two
};

}  // namespace vitrail
