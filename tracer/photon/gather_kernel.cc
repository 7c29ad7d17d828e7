// The fixed-radius density estimate of photon mapping [J96], as one pass over contiguous photons. A search tree would
// find the same photons; here the grid of photon_map.h hands over a few runs of neighbours, most of them inside the
// disc, so it is fastest to test every photon, 16 at a time, and to add the flux of a photon outside as zero.
//
// The 16 lanes are virtual: one register of AVX-512, two of AVX2, four of NEON. What a lane adds, and how the lanes are
// added at the end, does not depend on the width of a register, and products and sums stay apart (-ffp-contract=off, no
// fused multiply-add): the sum has the same bits on every machine.

#include "photon/gather_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "photon/gather_kernel.cc"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vitrail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kLanes = 16;
constexpr hn::CappedTag<float, kLanes> kFloats;
constexpr hn::RebindToSigned<decltype(kFloats)> kInts;
constexpr int kWidth = hn::MaxLanes(kFloats), kRegisters = kLanes / kWidth;
using Floats = hn::Vec<decltype(kFloats)>;
using Mask = hn::Mask<decltype(kFloats)>;

// Which of the photons from i on are inside the disc and arrived on its side.
HWY_INLINE Mask is_inside(const PhotonColumns& columns, const GatherDisc& disc, std::uint32_t i) {
  // Find the squared distance along the tangent plane from the whole distance and the offset from the plane.
  const Floats dx = hn::LoadU(kFloats, columns.position[0] + i) - hn::Set(kFloats, disc.center[0]);
  const Floats dy = hn::LoadU(kFloats, columns.position[1] + i) - hn::Set(kFloats, disc.center[1]);
  const Floats dz = hn::LoadU(kFloats, columns.position[2] + i) - hn::Set(kFloats, disc.center[2]);
  const Floats offset = dx * hn::Set(kFloats, disc.normal[0]) + dy * hn::Set(kFloats, disc.normal[1]) +
                        dz * hn::Set(kFloats, disc.normal[2]);
  const Floats offset_squared = offset * offset;
  const Floats along_squared = dx * dx + dy * dy + dz * dz - offset_squared;
  const Mask is_near = hn::And(along_squared < hn::Set(kFloats, disc.radius_squared),
                               offset_squared < hn::Set(kFloats, disc.offset_squared));

  // Leave out the photons that arrived on the other side, or on a surface that is turned away.
  const auto normal = hn::LoadU(kInts, reinterpret_cast<const std::int32_t*>(columns.normal) + i);
  const auto side = hn::Xor(hn::ShiftLeftSame(normal, disc.normal_shift), hn::Set(kInts, disc.normal_flip));
  const auto turned_away = side < hn::Set(kInts, disc.normal_least);
  return hn::AndNot(hn::RebindMask(kFloats, turned_away), is_near);
}

// What each lane has summed so far.
struct Sums {
  Floats red[kRegisters], green[kRegisters], blue[kRegisters];

  HWY_INLINE Sums() {
    for (int r = 0; r < kRegisters; ++r) red[r] = green[r] = blue[r] = hn::Zero(kFloats);
  }
  HWY_INLINE void add(Mask inside, const PhotonColumns& columns, std::uint32_t i, int r) {
    red[r] = red[r] + hn::IfThenElseZero(inside, hn::LoadU(kFloats, columns.flux[0] + i));
    green[r] = green[r] + hn::IfThenElseZero(inside, hn::LoadU(kFloats, columns.flux[1] + i));
    blue[r] = blue[r] + hn::IfThenElseZero(inside, hn::LoadU(kFloats, columns.flux[2] + i));
  }
};

// Add 16 lanes as a binary tree: the upper half onto the lower half, four times.
template <typename Tag>
HWY_INLINE float sum_of_lanes(Tag lanes, hn::Vec<Tag> v) {
  if constexpr (hn::MaxLanes(lanes) == 1) {
    return hn::GetLane(v);
  } else {
    const hn::Half<Tag> half;
    return sum_of_lanes(half, hn::LowerHalf(half, v) + hn::UpperHalf(half, v));
  }
}
HWY_INLINE float sum_of(Floats (&registers)[kRegisters]) {
  for (int half = kRegisters / 2; half > 0; half /= 2) {
    for (int r = 0; r < half; ++r) registers[r] = registers[r] + registers[r + half];
  }
  return sum_of_lanes(kFloats, registers[0]);
}

Rgb flux_in_disc_lanes(const PhotonColumns& columns, const PhotonRun* runs, int run_count, const GatherDisc& disc) {
  Sums sums;
  for (int run = 0; run < run_count; ++run) {
    // Take 16 photons at a time, and then the rest of the run without the photons of the next one.
    std::uint32_t i = runs[run].begin;
    const std::uint32_t end = runs[run].end;
    for (; i + kLanes <= end; i += kLanes) {
      for (int r = 0; r < kRegisters; ++r) {
        const std::uint32_t at = i + static_cast<std::uint32_t>(r * kWidth);
        sums.add(is_inside(columns, disc, at), columns, at, r);
      }
    }
    if (i == end) continue;
    for (int r = 0; r < kRegisters; ++r) {
      const std::uint32_t at = i + static_cast<std::uint32_t>(r * kWidth);
      const auto in_run = hn::Iota(kInts, 0) < hn::Set(kInts, static_cast<std::int32_t>(end - at));
      sums.add(hn::And(is_inside(columns, disc, at), hn::RebindMask(kFloats, in_run)), columns, at, r);
    }
  }
  return {sum_of(sums.red), sum_of(sums.green), sum_of(sums.blue)};
}

}  // namespace vitrail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vitrail {

HWY_EXPORT(flux_in_disc_lanes);

Rgb flux_in_disc(const PhotonColumns& columns, const PhotonRun* runs, int run_count, const GatherDisc& disc) {
  return HWY_DYNAMIC_DISPATCH(flux_in_disc_lanes)(columns, runs, run_count, disc);
}

}  // namespace vitrail
#endif
