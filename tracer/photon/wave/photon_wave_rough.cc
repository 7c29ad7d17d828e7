/// What happens to the photons of a wave at rough faces, as material/roughen says it ray by ray.

#include <bit>

#include "optics/microsurface.h"
#include "photon/wave/photon_wave.h"

namespace vitrail {

// Draw the random numbers of every photon at this face: the same as PhotonTree draws.
void PhotonWave::draw(const Group& group) {
  RoughSamples& samples = *samples_;
  Stream stream{};
  std::uint64_t last = ~std::uint64_t{0};
  for (std::size_t i = 0; i < group.count; ++i) {
    const DiscreteState& state = now_.state(group.lane[i]);
    const Depth depth = state.depth();
    const auto bounce = static_cast<std::uint64_t>(64 * depth.reflections + depth.transmissions);
    if (bounce != last) stream = within(lots_, bounce);
    last = bounce;
    const auto u = padded_4d(stream, state.index);
    Stream behind{0};
    for (int d = 0; d < 3; ++d) {
      samples.u[d][i] = u[d];
      behind = within(behind, std::bit_cast<std::uint64_t>(u[d]));
    }
    behind_[i] = behind;
  }
}

void PhotonWave::deflect_part(const Group& group, Part& part, double side) {
  RoughSamples& samples = *samples_;
  for (std::size_t i = 0; i < group.count; ++i) samples.keep[i] = uniform(behind_[i], 0, 0);
  const double strength = std::get<Equation8>(face_of(group).material->roughness).value;
  deflect(samples, group.count, strength, !scene_.paper.rough_photons_literal, lanes_->normal, side, *part.direction);
}

// Divide the light at the first facet, and let each part find its way from there.
void PhotonWave::divide_at_facets(const Group& group) {
  const Face& face = face_of(group);
  FacetLanes& facets = *facets_;
  find_facets(*lanes_, *samples_, std::get<Ggx>(face.material->roughness).alpha, facets);
  refract(facets.at);
  reflect(facets.at);
  if (face.material->fresnel) find_fresnel_shares(facets.at);
  share_at_facets(group);
  mirrored_.direction = &facets.at.mirrored;
  refracted_.direction = &facets.at.refracted;
  if (face.mirrors || face.material->fresnel || any_total_) {
    let_leave(group, mirrored_, false);
    mirrored_.goes_on = true;
  }
  if (!face.transmits) return;
  let_leave(group, refracted_, true);
  refracted_.goes_on = true;
}

// What each part carries away from its first facet. At a facet of total reflection both go back.
void PhotonWave::share_at_facets(const Group& group) {
  const Face& face = face_of(group);
  const Material& material = *face.material;
  DielectricLanes& at = facets_->at;
  const bool glass = face.transmits, by_fresnel = material.fresnel;
  for (int c = 0; c < 3; ++c) {
    const double pool = face.pool[c], r = material.reflection[c], t = glass ? material.transmission[c] : 0;
    for (std::size_t i = 0; i < group.count; ++i) {
      const bool total = at.radicand[i] < 0;
      const double mirrored = !by_fresnel ? r : total ? pool : pool * at.share_R[i];
      const double refracted = !by_fresnel ? t : total || !glass ? 0.0 : pool * at.share_T[i];
      mirrored_.flux[c][i] = group.flux[c][i] * mirrored;
      refracted_.flux[c][i] = group.flux[c][i] * refracted;
    }
  }
  any_total_ = false;
  for (std::size_t i = 0; i < group.count; ++i) {
    const bool total = is_total(group, i);
    any_total_ = any_total_ | total;
    for (int a = 0; a < 3; ++a) at.refracted[a][i] = total ? at.mirrored[a][i] : at.refracted[a][i];
  }
}

// Let one part leave the face: at once, as most rays do, or from facet to facet.
void PhotonWave::let_leave(const Group& group, Part& part, bool bent) {
  const Face& face = face_of(group);
  RoughSamples& samples = *samples_;  // used up: room for what decides about the way out
  auto& [heights, below, lots] = samples.u;
  const bool by_fresnel = face.material->fresnel;
  for (std::size_t i = 0; i < group.count; ++i) {
    const bool total = is_total(group, i), behind = bent && !total;
    heights[i] = behind ? -(*part.direction)[2][i] : (*part.direction)[2][i];
    below[i] = behind ? 1 - facets_->below[i] : facets_->below[i];
    behind_facet_[i] = within(behind_[i], bent && (by_fresnel || !total) ? 1 : 0);
    lots[i] = uniform(behind_facet_[i], 0, 0);
  }
  const double alpha = std::get<Ggx>(face.material->roughness).alpha;
  escape_facets(group.count, alpha, heights, below, lots, samples.keep);

  for (std::size_t i = 0; i < group.count; ++i) {
    const bool total = is_total(group, i), escapes = samples.keep[i] > 0;
    // What is totally reflected and what is mirrored part ways only if they meet another facet.
    const bool takes_all = total && !by_fresnel && !bent && escapes;
    for (int c = 0; c < 3 && takes_all; ++c) {
      mirrored_.flux[c][i] = group.flux[c][i] * face.pool[c];
      refracted_.flux[c][i] = 0;
    }
    bool behind = bent && !total;
    if (!escapes && !is_black(part.flux_of(i))) behind = follow_facets(group, part, bent, i);
    const bool totally = bent || takes_all || (total && by_fresnel);
    part.lobe[i] = behind ? Lobe::transmission : totally ? Lobe::total_internal_reflection : Lobe::reflection;
    lots[i] = behind ? 1 : 0;
  }
  turn_to_world(*facets_, lanes_->normal, lots, *part.direction);
}

// Whether a facet sends everything back.
bool PhotonWave::is_total(const Group& group, std::size_t i) const {
  return face_of(group).transmits && facets_->at.radicand[i] < 0;
}

// Follow one ray from its first facet until it leaves the face; returns whether behind it.
bool PhotonWave::follow_facets(const Group& group, Part& part, bool bent, std::size_t i) {
  const Face& face = face_of(group);
  const DielectricLanes& at = facets_->at;
  const double alpha = std::get<Ggx>(face.material->roughness).alpha;
  const FacetLaw mirror = !face.material->fresnel ? FacetLaw::mirror : FacetLaw::mirror_by_fresnel;
  const FacetLaw divide = !face.material->fresnel ? FacetLaw::let_through : FacetLaw::divide_by_fresnel;
  const bool divides = bent || (face.material->fresnel && face.transmits);
  const Vec3 arrived{at.direction[0][i], at.direction[1][i], at.direction[2][i]};
  const Vec3 way{(*part.direction)[0][i], (*part.direction)[1][i], (*part.direction)[2][i]};

  FacetRay ray{way, {at.ior_from[i], at.ior_to[i], 0, at.ior_step[i]}, facets_->below[i]};
  if (bent && !is_total(group, i)) ray.cross(way);
  const double left = leave_facets(ray, {alpha, divides ? divide : mirror}, arrived, behind_facet_[i]);
  for (int c = 0; c < 3; ++c) part.flux[c][i] *= left;
  const Vec3 local = ray.behind ? -ray.direction : ray.direction;
  for (int a = 0; a < 3; ++a) (*part.direction)[a][i] = local[a];
  return ray.behind;
}

}  // namespace vitrail
