#include "photon/gather_kernel.h"

#include <cstring>

namespace vitrail {
namespace {

constexpr int kLanes = 16;

typedef float FourFloats __attribute__((vector_size(16)));

// Add 16 lanes as a binary tree: halves onto each other, four times.
inline float sum_of(const float (&lanes)[kLanes]) {
  FourFloats quarter[4];
  std::memcpy(quarter, lanes, sizeof quarter);
  const FourFloats sums = (quarter[0] + quarter[2]) + (quarter[1] + quarter[3]);
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

}  // namespace

// One text of the loop, compiled for registers of 16 floats and of 8. Products and sums stay apart (-ffp-contract=off,
// no fused multiply-add), or the two would round differently.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx512f")
#define VITRAIL_REGISTER_LANES 16
#define VITRAIL_KERNEL flux_in_disc_by_16
#include "photon/gather_loop.inc"
#undef VITRAIL_REGISTER_LANES
#undef VITRAIL_KERNEL
#pragma GCC pop_options
#endif

#define VITRAIL_REGISTER_LANES 8
#define VITRAIL_KERNEL flux_in_disc_by_8
#include "photon/gather_loop.inc"
#undef VITRAIL_REGISTER_LANES
#undef VITRAIL_KERNEL

GatherKernel gather_kernel(GatherWidth width) {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  const bool wide = width == GatherWidth::widest && __builtin_cpu_supports("avx512f");
  return wide ? flux_in_disc_by_16 : flux_in_disc_by_8;
#else
  static_cast<void>(width);
  return flux_in_disc_by_8;
#endif
}

}  // namespace vitrail
