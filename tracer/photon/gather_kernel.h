#pragma once
/// The innermost loop of the photon map: sum the flux of the photons inside one disc.

#include <array>
#include <cstdint>

#include "base/vec3.h"

namespace vitrail {

/// Photons begin .. end of the sorted arrays, contiguous in memory.
struct PhotonRun {
  std::uint32_t begin, end;
};

/// The sorted arrays, readable for `kPadding` elements past the last photon.
struct PhotonColumns {
  static constexpr std::size_t kPadding = 16;

  std::array<const float*, 3> position;
  std::array<const float*, 3> flux;
  const std::uint32_t* normal;  // three signed bytes, the lowest first
};

/// A disc of radius R on a tangent plane, in the floats of the photon frame and the axes of the columns.
struct GatherDisc {
  float center[3];
  float normal[3];
  float radius_squared;
  float offset_squared;       // the largest squared distance from the tangent plane
  int normal_shift;           // brings the byte of the query normal's largest component to the top
  std::int32_t normal_flip;   // -1 if that component is negative, else 0
  std::int32_t normal_least;  // what the photon's normal must have along that component, as a top byte
};

/// Sum of the flux of every photon of the runs inside the disc, per channel, W. Photon i of a run always goes to lane
/// i mod 16, and the lanes are added in one fixed order, so every instruction set gives the same bits.
Rgb flux_in_disc(const PhotonColumns& columns, const PhotonRun* runs, int run_count, const GatherDisc& disc);

}  // namespace vitrail
