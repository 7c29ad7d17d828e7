// Rough faces for columns of rays. As in dielectric_lanes.cc, both sides of each question are computed and a mask
// selects. Powers, sines and cosines are series of products and sums, so that every machine gives the same bits.

#include "photon/wave/rough_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "photon/wave/rough_lanes.cc"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include "photon/wave/vec3_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vitrail::HWY_NAMESPACE {

using Column = DielectricLanes::Column;
using Columns = std::array<Column, 3>;

HWY_INLINE Doubles at(const Column& column, std::size_t i) { return hn::Load(kDoubles, &column[i]); }
HWY_INLINE void put(Doubles v, Column& column, std::size_t i) { hn::Store(v, kDoubles, &column[i]); }

// A polynomial of the coefficients, the highest power first.
template <std::size_t kCount>
HWY_INLINE Doubles polynomial(Doubles x, const double (&coefficients)[kCount]) {
  Doubles sum = broadcast(coefficients[0]);
  for (std::size_t k = 1; k < kCount; ++k) sum = sum * x + broadcast(coefficients[k]);
  return sum;
}

struct SineCosineLanes {
  Doubles sine, cosine;
};

// base/sine_cosine, lane by lane.
HWY_INLINE SineCosineLanes sine_cosine_of_turn(Doubles turn) {
  const Ints quarters = hn::ConvertTo(kInts, broadcast(4) * turn + broadcast(0.5)), two = hn::Set(kInts, 2);
  const Doubles x = broadcast(2 * M_PI) * (turn - broadcast(0.25) * hn::ConvertTo(kDoubles, quarters)), y = x * x;
  const Doubles sine = x * polynomial(y, {-1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880,
                                          -1.0 / 5040, 1.0 / 120, -1.0 / 6, 1.0});
  const Doubles cosine = polynomial(y, {1.0 / 20922789888000, -1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800,
                                        1.0 / 40320, -1.0 / 720, 1.0 / 24, -0.5, 1.0});
  const Ints one = hn::Set(kInts, 1);
  const Mask swapped = hn::RebindMask(kDoubles, hn::And(quarters, one) == one);
  const Doubles s = select(swapped, cosine, sine), c = select(swapped, sine, cosine);
  const Mask below = hn::RebindMask(kDoubles, hn::And(quarters, two) == two);
  const Mask left = hn::RebindMask(kDoubles, hn::And(quarters + one, two) == two);
  return {select(below, hn::Neg(s), s), select(left, hn::Neg(c), c)};
}

// The natural logarithm of a normal number: 2 artanh((m - 1) / (m + 1)) of its mantissa m between sqrt(1/2) and
// sqrt(2), by the series.
HWY_INLINE Doubles logarithm(Doubles x) {
  const hn::RebindToUnsigned<decltype(kDoubles)> bits;
  const auto raw = hn::BitCast(bits, x);
  const Doubles mantissa = hn::BitCast(
      kDoubles, hn::Or(hn::And(raw, hn::Set(bits, 0x000fffffffffffffull)), hn::Set(bits, 0x3ff0000000000000ull)));
  const Mask upper = mantissa > broadcast(1.4142135623730951);
  const Doubles m = select(upper, mantissa * broadcast(0.5), mantissa);
  const Ints power = hn::BitCast(kInts, hn::ShiftRight<52>(raw)) - hn::Set(kInts, 1023);
  const Doubles exponent = hn::ConvertTo(kDoubles, power) + select(upper, broadcast(1), broadcast(0));
  const Doubles s = (m - broadcast(1)) / (m + broadcast(1)), y = s * s;
  const Doubles series = polynomial(y, {1.0 / 23, 1.0 / 21, 1.0 / 19, 1.0 / 17, 1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9,
                                        1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0});
  return exponent * broadcast(0.693147180559945309) + broadcast(2) * s * series;
}

// e^x for x <= 0: a power of two times a series; 0 below the smallest normal number.
HWY_INLINE Doubles exponential(Doubles x) {
  const Mask vanishes = x < broadcast(-700);
  const Doubles kept = select(vanishes, broadcast(0), x);
  const Ints power = hn::ConvertTo(kInts, kept * broadcast(1.442695040888963407) - broadcast(0.5));
  const Doubles whole = hn::ConvertTo(kDoubles, power);
  // Take the multiple of ln 2 off in two parts, the first of which is exact.
  const Doubles r = kept - whole * broadcast(0x1.62e42feep-1) - whole * broadcast(0x1.a39ef35793c76p-33);
  const Doubles series =
      polynomial(r, {1.0 / 87178291200, 1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880,
                     1.0 / 40320, 1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0});
  const Doubles scale = hn::BitCast(kDoubles, hn::ShiftLeft<52>(power + hn::Set(kInts, 1023)));
  return select(vanishes, broadcast(0), series * scale);
}

// For x in [0, 1] and y >= 0.
HWY_INLINE Doubles power(Doubles x, Doubles y) {
  const Doubles least = broadcast(0x1p-1022);
  return exponential(y * logarithm(select(x > least, x, least)));
}

HWY_INLINE Doubles not_negative(Doubles x) { return select(x > broadcast(0), x, broadcast(0)); }

// optics/roughness: deflect and deflect_light.
void deflect_lanes(const RoughSamples& samples, std::size_t count, double strength, bool reciprocal,
                   const Columns& normal, double side, Columns& direction) {
  const Doubles zero = broadcast(0), one = broadcast(1), two = broadcast(2);
  for (std::size_t i = 0; i < count; i += kWidth) {
    const Vec3Lanes before = load(direction, i), facing = load(normal, i) * broadcast(side);
    const Doubles height = one - two * at(samples.u[1], i);
    const Doubles radius = hn::Sqrt(not_negative(one - height * height));
    const auto [sine, cosine] = sine_cosine_of_turn(at(samples.u[2], i));
    const Vec3Lanes mu{radius * cosine, radius * sine, height};
    const Vec3Lanes rho = mu - before * dot(mu, before);
    const Doubles gamma = at(samples.u[0], i) * broadcast(strength / 2);
    Vec3Lanes bent = normalise(before * (one - gamma) + rho * gamma);
    const Doubles above = dot(bent, facing);
    bent = select(above < zero, bent - facing * (two * above), bent);

    // Light that would end up too close to the face goes straight on.
    const Mask accepted = at(samples.keep, i) * dot(before, facing) < dot(bent, facing);
    store(reciprocal ? select(accepted, bent, before) : bent, direction, i);
  }
}

// Smith's Lambda of GGX: optics/microsurface.
HWY_INLINE Doubles smith_lambda(Doubles cosine, double alpha) {
  const Doubles one = broadcast(1), two = broadcast(2), squared = cosine * cosine;
  const Doubles slope = broadcast(alpha * alpha) * not_negative(one - squared) / squared;
  const Doubles root = hn::Sqrt(one + slope);
  return select(cosine > broadcast(0), slope / (two * (one + root)), hn::Neg(one + root) / two);
}

// Across a unit direction: base/frame's surface_frame.
struct FrameLanes {
  Vec3Lanes u, v;
};

HWY_INLINE Vec3Lanes cross(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

HWY_INLINE FrameLanes surface_frame(const Vec3Lanes& normal) {
  const Mask steep = hn::Abs(normal.x) > broadcast(0.9);
  const Vec3Lanes a = select(steep, broadcast(Vec3{0, 0, 1}), broadcast(Vec3{1, 0, 0}));
  const Vec3Lanes u = normalise(a - normal * dot(a, normal));
  return {u, cross(normal, u)};
}

// optics/roughness: ggx_normal about the z axis.
HWY_INLINE Vec3Lanes ggx_normal(const Vec3Lanes& toward_viewer, double alpha, Doubles first, Doubles second) {
  const Doubles zero = broadcast(0), one = broadcast(1), rough = broadcast(alpha);
  const Vec3Lanes view = normalise({rough * toward_viewer.x, rough * toward_viewer.y, toward_viewer.z});
  const Vec3Lanes flat{hn::Neg(view.y), view.x, zero};
  const Mask leans = dot(flat, flat) > zero;
  const Vec3Lanes sideways = normalise(select(leans, flat, broadcast(Vec3{1, 0, 0})));
  const Vec3Lanes upwards = cross(view, sideways);
  const auto [sine, cosine] = sine_cosine_of_turn(second);
  const Doubles r = hn::Sqrt(first), a = r * cosine, lean = broadcast(0.5) * (one + view.z);
  const Doubles b = (one - lean) * hn::Sqrt(not_negative(one - a * a)) + lean * r * sine;
  const Vec3Lanes chosen = sideways * a + upwards * b + view * hn::Sqrt(not_negative(one - a * a - b * b));
  const Doubles least = broadcast(1e-300);
  return normalise({rough * chosen.x, rough * chosen.y, select(chosen.z > least, chosen.z, least)});
}

void find_facets_lanes(const DielectricLanes& lanes, const RoughSamples& samples, double alpha, FacetLanes& facets) {
  facets.at.count = lanes.count;
  const Doubles one = broadcast(1);
  for (std::size_t i = 0; i < lanes.count; i += kWidth) {
    const Vec3Lanes ray = load(lanes.direction, i), normal = load(lanes.normal, i);
    const auto [u, v] = surface_frame(normal);
    const Vec3Lanes arrived{dot(ray, u), dot(ray, v), dot(ray, normal)};
    const Vec3Lanes viewer{hn::Neg(arrived.x), hn::Neg(arrived.y), hn::Neg(arrived.z)};
    store(u, facets.u, i);
    store(v, facets.v, i);
    store(arrived, facets.at.direction, i);
    store(ggx_normal(viewer, alpha, at(samples.u[0], i), at(samples.u[1], i)), facets.at.normal, i);
    put(power(one - at(samples.u[2], i), hn::Neg(one) / smith_lambda(arrived.z, alpha)), facets.below, i);
    put(at(lanes.ior_from, i), facets.at.ior_from, i);
    put(at(lanes.ior_to, i), facets.at.ior_to, i);
    put(at(lanes.ior_step, i), facets.at.ior_step, i);
  }
}

void escape_facets_lanes(std::size_t count, double alpha, const Column& z, const Column& below, const Column& u,
                         Column& escapes) {
  const Doubles zero = broadcast(0), one = broadcast(1);
  for (std::size_t i = 0; i < count; i += kWidth) {
    const Doubles height = at(z, i);
    const Mask upwards = height > zero;
    const Doubles per_facet = smith_lambda(select(upwards, height, one), alpha);
    const Mask leaves = at(u, i) >= one - power(at(below, i), per_facet);
    put(hn::IfThenElseZero(hn::And(upwards, leaves), one), escapes, i);
  }
}

void turn_to_world_lanes(const FacetLanes& facets, const Columns& normal, const Column& behind, Columns& direction) {
  const Doubles zero = broadcast(0), two = broadcast(2);
  for (std::size_t i = 0; i < facets.at.count; i += kWidth) {
    const Vec3Lanes local = load(direction, i), facing = load(normal, i);
    const Vec3Lanes way = normalise(load(facets.u, i) * local.x + load(facets.v, i) * local.y + facing * local.z);
    const Doubles above = dot(way, facing);
    const Mask is_behind = at(behind, i) > zero;
    const Doubles wrong = select(is_behind, not_negative(above), hn::Neg(not_negative(hn::Neg(above))));
    store(way - facing * (two * wrong), direction, i);
  }
}

}  // namespace vitrail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vitrail {

HWY_EXPORT(deflect_lanes);
HWY_EXPORT(find_facets_lanes);
HWY_EXPORT(escape_facets_lanes);
HWY_EXPORT(turn_to_world_lanes);

void deflect(const RoughSamples& samples, std::size_t count, double strength, bool reciprocal,
             const std::array<DielectricLanes::Column, 3>& normal, double side,
             std::array<DielectricLanes::Column, 3>& direction) {
  HWY_DYNAMIC_DISPATCH(deflect_lanes)(samples, count, strength, reciprocal, normal, side, direction);
}
void find_facets(const DielectricLanes& lanes, const RoughSamples& samples, double alpha, FacetLanes& facets) {
  HWY_DYNAMIC_DISPATCH(find_facets_lanes)(lanes, samples, alpha, facets);
}
void escape_facets(std::size_t count, double alpha, const DielectricLanes::Column& z,
                   const DielectricLanes::Column& below, const DielectricLanes::Column& u,
                   DielectricLanes::Column& escapes) {
  HWY_DYNAMIC_DISPATCH(escape_facets_lanes)(count, alpha, z, below, u, escapes);
}
void turn_to_world(const FacetLanes& facets, const std::array<DielectricLanes::Column, 3>& normal,
                   const DielectricLanes::Column& behind, std::array<DielectricLanes::Column, 3>& direction) {
  HWY_DYNAMIC_DISPATCH(turn_to_world_lanes)(facets, normal, behind, direction);
}

}  // namespace vitrail
#endif
