/// Three columns of doubles, read and written as vectors of lanes: Vec3 for the loops over many photons. Included once
/// for each instruction set, hence the guard that Highway toggles.

#if defined(VITRAIL_VEC3_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VITRAIL_VEC3_LANES_INL_H
#undef VITRAIL_VEC3_LANES_INL_H
#else
#define VITRAIL_VEC3_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "base/vec3.h"

HWY_BEFORE_NAMESPACE();
namespace vitrail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::ScalableTag<double> kDoubles;
constexpr hn::RebindToSigned<decltype(kDoubles)> kInts;
constexpr std::size_t kWidth = hn::MaxLanes(kDoubles);
using Doubles = hn::Vec<decltype(kDoubles)>;
using Ints = hn::Vec<decltype(kInts)>;
using Mask = hn::Mask<decltype(kDoubles)>;

HWY_INLINE Doubles broadcast(double value) { return hn::Set(kDoubles, value); }

struct Vec3Lanes {
  Doubles x, y, z;
};

HWY_INLINE Vec3Lanes broadcast(Vec3 v) { return {broadcast(v.x), broadcast(v.y), broadcast(v.z)}; }

/// `columns[axis]` is an array or a pointer; element i on.
template <typename Columns>
HWY_INLINE Vec3Lanes load(const Columns& columns, std::size_t i) {
  return {hn::LoadU(kDoubles, &columns[0][i]), hn::LoadU(kDoubles, &columns[1][i]),
          hn::LoadU(kDoubles, &columns[2][i])};
}
template <typename Columns>
HWY_INLINE void store(const Vec3Lanes& v, Columns& columns, std::size_t i) {
  hn::StoreU(v.x, kDoubles, &columns[0][i]);
  hn::StoreU(v.y, kDoubles, &columns[1][i]);
  hn::StoreU(v.z, kDoubles, &columns[2][i]);
}

HWY_INLINE Vec3Lanes operator+(const Vec3Lanes& a, const Vec3Lanes& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE Vec3Lanes operator-(const Vec3Lanes& a, const Vec3Lanes& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE Vec3Lanes operator*(const Vec3Lanes& a, Doubles s) { return {a.x * s, a.y * s, a.z * s}; }
HWY_INLINE Doubles dot(const Vec3Lanes& a, const Vec3Lanes& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE Vec3Lanes normalise(const Vec3Lanes& a) { return a * (broadcast(1) / hn::Sqrt(dot(a, a))); }

HWY_INLINE Doubles select(Mask mask, Doubles yes, Doubles no) { return hn::IfThenElse(mask, yes, no); }
HWY_INLINE Vec3Lanes select(Mask mask, const Vec3Lanes& yes, const Vec3Lanes& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

}  // namespace vitrail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
