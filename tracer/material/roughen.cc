#include "material/roughen.h"

#include <bit>

#include "base/frame.h"
#include "material/boundary.h"
#include "optics/fresnel.h"
#include "optics/microsurface.h"
#include "optics/roughness.h"

namespace vitrail {
namespace {

// More random numbers where three do not suffice: a hash of those three.
Stream behind(const RoughSample& sample) {
  Stream stream{0};
  for (const double u : sample) stream = within(stream, std::bit_cast<std::uint64_t>(u));
  return stream;
}

// Equation 8 as it is printed, or the form that leaves Lambert's law as it is.
enum class Deflection { literal, reciprocal };

void deflect_branches(const RoughSample& sample, double lambda, Deflection deflection, Interaction& event) {
  const bool reciprocal = deflection == Deflection::reciprocal;
  const double keep = reciprocal ? uniform(behind(sample), 0, 0) : 0;
  const auto turn = [&](Branch& branch, Vec3 facing) {
    if (!branch.exists) return;
    branch.direction = reciprocal ? deflect_light(branch.direction, lambda, facing, sample, keep)
                                  : deflect(branch.direction, lambda, facing, sample);
  };
  turn(event.reflect, event.facing_normal);
  turn(event.transmit, -event.facing_normal);
}

/// A hit on a face of GGX facets.
class GgxFace {
 public:
  GgxFace(const Scene& scene, const Incidence& incidence, double alpha, const Interaction& event)
      : hit_(incidence.hit),
        paper_(scene.paper),
        alpha_(alpha),
        bend_(scene.paper.refraction_literal ? refract_literal : refract),
        facing_(event.facing_normal),
        across_(surface_frame(event.facing_normal)),
        arrived_{dot(incidence.direction, across_.u), dot(incidence.direction, across_.v),
                 dot(incidence.direction, facing_)} {
    find_boundary(scene, hit_, incidence.media, boundary_);
    shares_ = shares_of(scene, boundary_);
  }

  /// Divide the light at the first facet, and let each part find its way from there.
  void scatter(const RoughSample& sample, Interaction& event) const {
    FacetRay met{arrived_, event.index};
    reach_facet(met, alpha_, sample[2]);
    const Vec3 facet = ggx_normal(-arrived_, {0, 0, 1}, alpha_, sample[0], sample[1]);
    const Refraction refraction = bend_(arrived_, facet, event.index);
    const FresnelShares at_facet = fresnel(event.index, refraction);
    event.R = at_facet.R;
    event.T = at_facet.T;
    event.total_internal_reflection = !boundary_.opaque && refraction.total;
    const bool total = event.total_internal_reflection;

    FacetRay mirrored = met, bent = met;
    mirrored.reflect_at(facet);
    refraction.total ? bent.reflect_at(facet) : bent.cross(refraction.direction);

    // Each part has random numbers of its own behind the first facet.
    const Stream stream = behind(sample);
    const Stream one = within(stream, 0), other = within(stream, 1);
    const Rgb none;
    const bool drops = total && paper_.tir_drop;
    if (shares_.fresnel) {
      const FacetLaw law = boundary_.opaque ? FacetLaw::mirror_by_fresnel : FacetLaw::divide_by_fresnel;
      const Rgb back = drops ? shares_.reflection : shares_.pool() * at_facet.R;
      leave(mirrored, law, back, total && !drops ? Lobe::total_internal_reflection : Lobe::reflection, one,
            event.reflect);
      leave(bent, law, boundary_.opaque ? none : shares_.pool() * at_facet.T, Lobe::total_internal_reflection, other,
            event.transmit);
      return;
    }

    // What is totally reflected and what is mirrored part ways only if they meet another facet.
    FacetRay away = mirrored;
    if (total && !drops && !reach_facet(away, alpha_, uniform(one, 0, 0))) {
      leave(mirrored, FacetLaw::mirror, shares_.pool(), Lobe::total_internal_reflection, one, event.reflect);
      event.transmit.exists = false;
      return;
    }
    const Rgb passing = boundary_.opaque || drops ? none : shares_.transmission;
    leave(mirrored, FacetLaw::mirror, shares_.reflection, Lobe::reflection, one, event.reflect);
    leave(bent, FacetLaw::let_through, passing, Lobe::total_internal_reflection, total ? one : other, event.transmit);
  }

 private:
  // `back`: what a ray counts as that ends on the side from which the light came.
  void leave(FacetRay ray, FacetLaw law, const Rgb& weight, Lobe back, Stream stream, Branch& branch) const {
    branch.exists = false;
    if (is_black(weight)) return;
    const double left = leave_facets(ray, {alpha_, law, bend_}, arrived_, stream);
    const Vec3 local = ray.behind ? -ray.direction : ray.direction;
    Vec3 way = normalise(across_.u * local.x + across_.v * local.y + facing_ * local.z);

    // Keep it on its side of the surface itself, where the shading normal of a smooth mesh leans.
    const Vec3 outward = boundary_.interface->entering ? boundary_.interface->normal : -boundary_.interface->normal;
    const double above = dot(way, outward);
    if (ray.behind ? above > 0 : above < 0) way = way - outward * (2 * above);
    if (ray.behind) {
      branch.set(Lobe::transmission, way, weight * left, hit_.through(), boundary_.after);
    } else {
      branch.set(back, way, weight * left, hit_.back(), boundary_.before);
    }
  }

  const Hit& hit_;
  const Paper& paper_;
  double alpha_;
  Refraction (*bend_)(Vec3, Vec3, const IndexPair&);
  Vec3 facing_;
  SurfaceFrame across_;
  Vec3 arrived_;
  Boundary boundary_;
  Shares shares_;
};

}  // namespace

bool is_rough(const Roughness& roughness) {
  const auto* by_equation_8 = std::get_if<Equation8>(&roughness);
  return std::holds_alternative<Ggx>(roughness) || (by_equation_8 != nullptr && by_equation_8->value > 0);
}

void roughen(const Scene& scene, const Incidence& incidence, const RoughSample& sample, Transported transported,
             Interaction& event) {
  if (!event.reflect.exists && !event.transmit.exists) return;
  if (const auto* by_equation_8 = std::get_if<Equation8>(&event.roughness)) {
    const bool keeps_lambert = transported == Transported::flux && !scene.paper.rough_photons_literal;
    const Deflection deflection = keeps_lambert ? Deflection::reciprocal : Deflection::literal;
    deflect_branches(sample, by_equation_8->value, deflection, event);
  } else if (const auto* ggx = std::get_if<Ggx>(&event.roughness)) {
    GgxFace(scene, incidence, ggx->alpha, event).scatter(sample, event);
  }
}

}  // namespace vitrail
