// A dielectric face for many rays at once: pbrt's `Reflect`, `Refract` and `FrDielectric`, but for whole columns of
// rays and without a branch, because neighbouring rays differ: one is reflected totally, the next meets matched
// indices. So both sides of each question are computed, and a mask selects. Each lane has the same operations in the
// same order as optics/refract and optics/fresnel, apart from one division per vector in place of three.

#include "photon/wave/dielectric_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "photon/wave/dielectric_lanes.cc"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include "photon/wave/vec3_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vitrail::HWY_NAMESPACE {

HWY_INLINE Doubles load(const DielectricLanes::Column& column, std::size_t i) { return hn::Load(kDoubles, &column[i]); }
HWY_INLINE void store(Doubles v, DielectricLanes::Column& column, std::size_t i) { hn::Store(v, kDoubles, &column[i]); }

void reflect_lanes(DielectricLanes& lanes) {
  for (std::size_t i = 0; i < lanes.count; i += kWidth) {
    const Vec3Lanes ray = load(lanes.direction, i), normal = load(lanes.normal, i);
    const Doubles twice = broadcast(2) * dot(ray, normal);
    store(normalise(ray - normal * twice), lanes.mirrored, i);
  }
}

void refract_lanes(DielectricLanes& lanes) {
  const Doubles zero = broadcast(0), one = broadcast(1);
  for (std::size_t i = 0; i < lanes.count; i += kWidth) {
    const Vec3Lanes ray = load(lanes.direction, i), normal = load(lanes.normal, i);
    const Doubles n1 = load(lanes.ior_from, i), n2 = load(lanes.ior_to, i), step = load(lanes.ior_step, i);
    const Doubles against = hn::Neg(dot(ray, normal));
    const Doubles above = select(against > zero, against, zero);
    const Doubles cos_in = select(above < one, above, one);

    // Form the radicand from the difference of the indices, but from the sine far into the thinner medium, as
    // optics/refract explains.
    const Doubles eta = n1 / n2, one_minus_eta = step / n2;
    const Vec3Lanes tangential = ray + normal * cos_in;
    const Doubles by_sine = one - eta * eta * dot(tangential, tangential);
    const Doubles by_step = one_minus_eta * (one + eta) + (eta * cos_in) * (eta * cos_in);
    const Doubles radicand = select(eta > broadcast(2), by_sine, by_step);

    // Let the ray through unbent where the indices are equal, to the last bit.
    const Mask matched = step == zero;
    const Doubles cos_out = select(matched, cos_in, hn::Sqrt(select(radicand > zero, radicand, zero)));
    const Vec3Lanes bent = normalise(tangential * eta - normal * cos_out);
    store(radicand, lanes.radicand, i);
    store(cos_in, lanes.cos_in, i);
    store(cos_out, lanes.cos_out, i);
    store(select(matched, ray, bent), lanes.refracted, i);
  }
}

// R and T each on its own, as optics/fresnel does: T as 1 - R would lose its digits near grazing.
void find_fresnel_shares_lanes(DielectricLanes& lanes) {
  const Doubles zero = broadcast(0), one = broadcast(1), two = broadcast(2), four = broadcast(4);
  for (std::size_t i = 0; i < lanes.count; i += kWidth) {
    const Doubles n1 = load(lanes.ior_from, i), n2 = load(lanes.ior_to, i), step = load(lanes.ior_step, i);
    const Doubles cos_in = load(lanes.cos_in, i), cos_out = load(lanes.cos_out, i), eta = n1 / n2;
    const Doubles sum_s = n1 * cos_in + n2 * cos_out, sum_p = n2 * cos_in + n1 * cos_out;
    const Doubles sum_s_squared = sum_s * sum_s, sum_p_squared = sum_p * sum_p;
    const Doubles difference = step * (n1 + n2), sin2_in = (one - cos_in) * (one + cos_in);
    const Doubles r_s = hn::Neg(difference) / sum_s_squared;
    const Doubles r_p = difference * (cos_in * cos_in - eta * eta * sin2_in) / sum_p_squared;
    const Doubles flow = four * n1 * n2 * cos_in * cos_out;

    // Reflect all of a ray that grazes the face, where both sums vanish.
    const Mask goes_through = hn::And(sum_s > zero, sum_p > zero);
    store(select(goes_through, (r_s * r_s + r_p * r_p) / two, one), lanes.share_R, i);
    store(select(goes_through, (flow / sum_s_squared + flow / sum_p_squared) / two, zero), lanes.share_T, i);
  }
}

}  // namespace vitrail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vitrail {

HWY_EXPORT(reflect_lanes);
HWY_EXPORT(refract_lanes);
HWY_EXPORT(find_fresnel_shares_lanes);

void reflect(DielectricLanes& lanes) { HWY_DYNAMIC_DISPATCH(reflect_lanes)(lanes); }
void refract(DielectricLanes& lanes) { HWY_DYNAMIC_DISPATCH(refract_lanes)(lanes); }
void find_fresnel_shares(DielectricLanes& lanes) { HWY_DYNAMIC_DISPATCH(find_fresnel_shares_lanes)(lanes); }

}  // namespace vitrail
#endif
