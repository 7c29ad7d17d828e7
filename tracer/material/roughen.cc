#include "material/roughen.h"

#include "optics/roughness.h"

namespace vitrail {

bool is_rough(const Roughness& roughness) {
  const auto* by_equation_8 = std::get_if<Equation8>(&roughness);
  return std::holds_alternative<Ggx>(roughness) || (by_equation_8 != nullptr && by_equation_8->value > 0);
}

void roughen(const Scene& scene, const Hit& hit, Vec3 direction, const MediumSet& media, std::uint32_t band,
             bool ior_of_camera, const RoughSample& sample, Interaction& event) {
  if (!event.reflect.exists && !event.transmit.exists) return;
  const Vec3 facing = event.facing_normal;
  if (const auto* by_equation_8 = std::get_if<Equation8>(&event.roughness)) {
    const double lambda = by_equation_8->value;
    if (event.reflect.exists) event.reflect.direction = deflect(event.reflect.direction, lambda, facing, sample);
    if (event.transmit.exists) event.transmit.direction = deflect(event.transmit.direction, lambda, -facing, sample);
    return;
  }
  const auto* ggx = std::get_if<Ggx>(&event.roughness);
  if (ggx == nullptr) return;

  // Meet a microfacet: the same hit with its normal in place of the surface's.
  const Vec3 microfacet = ggx_normal(-direction, facing, ggx->alpha, sample[0], sample[1]);
  Hit on_microfacet = hit;
  for (Crossing& crossing : on_microfacet.crossings) {
    crossing.shading_normal = crossing.entering ? microfacet : -microfacet;
  }
  Interaction scattered;
  interact(scene, on_microfacet, direction, media, band, ior_of_camera, scattered);
  event.reflect = scattered.reflect;
  event.transmit = scattered.transmit;
  event.total_internal_reflection = scattered.total_internal_reflection;
  event.R = scattered.R;
  event.T = scattered.T;
}

}  // namespace vitrail
