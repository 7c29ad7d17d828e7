#include "material/surface.h"

#include "material/boundary.h"
#include "optics/absorption.h"
#include "optics/fresnel.h"
#include "optics/refract.h"

namespace vitrail {

namespace {

struct MediumIndex {
  double ior = 1, ior_minus_one = 0;
};

/// The index of a material's inside, whether it transmits or not.
MediumIndex index_of(const Material& material, std::uint32_t band, IorSource source) {
  if (source == IorSource::camera) return {material.camera_ior, material.camera_ior - 1};
  return {material.ior_by_band[band], material.ior_minus_one_by_band[band]};
}

/// The index that light meets where an object is dominant.
MediumIndex index_in(const Scene& scene, std::uint32_t object, std::uint32_t band, IorSource source) {
  if (object == kAir || !scene.material_of(object).transmits()) return {};
  return index_of(scene.material_of(object), band, source);
}

/// The shading normal against the light, or the geometric one where the shading normal of a smooth mesh turns away.
Vec3 facing_normal(const Crossing& surface, Vec3 direction) {
  const Vec3 shading = surface.entering ? surface.shading_normal : -surface.shading_normal;
  return dot(shading, direction) < 0 ? shading : surface.entering ? surface.normal : -surface.normal;
}

/// Bend the light at the shading normal, or at the geometric one where the shading normal of a smooth mesh would send
/// it to the wrong side of the surface. Sets the normal that was used, facing the light.
Refraction bend(const Paper& paper, const Crossing& surface, Vec3 direction, const IndexPair& index, Vec3& facing) {
  const double sign = surface.entering ? 1 : -1;
  const Vec3 geometric = surface.normal * sign;
  const auto at = [&](Vec3 normal) {
    return paper.refraction_literal ? refract_literal(direction, normal, index) : refract(direction, normal, index);
  };
  facing = surface.shading_normal * sign;
  Refraction refraction = at(facing);
  if (surface.shading_normal == surface.normal) return refraction;

  const bool mirrors_out = dot(reflect(direction, facing), geometric) > 0;
  const bool bends_in = refraction.total || dot(refraction.direction, geometric) < 0;
  if (dot(facing, direction) < 0 && mirrors_out && bends_in) return refraction;
  facing = geometric;
  return at(facing);
}

/// Divide the light among mirror and refraction.
void add_branches(const Paper& paper, const Hit& hit, Vec3 direction, const Boundary& boundary, const Shares& shares,
                  const Refraction& refraction, Interaction& result) {
  const Rgb pool = shares.pool();
  const bool transmits = !boundary.opaque && !refraction.total;
  Rgb mirrored = shares.fresnel ? pool * result.R : shares.reflection;
  Rgb refracted = shares.fresnel ? pool * result.T : shares.transmission;

  // Under total reflection the whole pool is sent back, unless the paper is read by the letter [O 1.1 row 8].
  Lobe back = Lobe::reflection;
  if (!boundary.opaque && refraction.total) {
    result.total_internal_reflection = true;
    mirrored = paper.tir_drop ? shares.reflection : pool;
    if (!paper.tir_drop) back = Lobe::total_internal_reflection;
  }
  if (!is_black(mirrored))
    result.reflect.set(back, reflect(direction, result.facing_normal), mirrored, hit.back(), boundary.before);
  if (transmits && !is_black(refracted))
    result.transmit.set(Lobe::transmission, refraction.direction, refracted, hit.through(), boundary.after);
}

/// Whose surface it is, and what it shows.
void describe(const Scene& scene, const Boundary& boundary, Interaction& result) {
  const Crossing& surface = *boundary.interface;
  result.object = boundary.object;
  result.material = scene.objects[result.object].material;
  const Material& material = scene.materials[result.material];
  result.entering = surface.entering;
  result.diffuse = boundary.other_interface == nullptr ? texture_at(material.diffuse, surface.s, surface.q) : Rgb{};
  result.emission = texture_at(material.emission, surface.s, surface.q);
  result.roughness = material.roughness;
}

}  // namespace

Interaction interact(const Scene& scene, const Incidence& incidence) {
  Interaction result;
  interact(scene, incidence, result);
  return result;
}

void interact(const Scene& scene, const Incidence& incidence, Interaction& result) {
  const auto& [hit, direction, media, band, ior] = incidence;
  Boundary boundary;
  find_boundary(scene, hit, media, boundary);
  result.medium_before = boundary.dominant_before;
  result.medium_after = boundary.dominant_after;

  // Go straight on where nothing changes: the same medium, or two pieces of one glass.
  const bool same_glass = boundary.other_interface != nullptr &&
                          scene.objects[result.medium_before].material == scene.objects[result.medium_after].material;
  result.passes = !boundary.opaque && (result.medium_before == result.medium_after || same_glass);
  if (result.passes) {
    result.transmit.set(Lobe::transmission, direction, {1, 1, 1}, hit.through(), boundary.after);
    return;
  }

  result.transmit.exists = false;
  result.reflect.exists = false;
  describe(scene, boundary, result);
  const Crossing& surface = *boundary.interface;
  const Material& material = scene.materials[result.material];
  const MediumIndex from = index_in(scene, result.medium_before, band, ior);
  result.index = {from.ior, from.ior, from.ior_minus_one, from.ior_minus_one};

  // Nothing leaves a dull surface in one direction.
  if (boundary.opaque && is_black(material.reflection)) {
    result.facing_normal = facing_normal(surface, direction);
    result.R = 0;
    result.T = 1;
    return;
  }

  // Bend the light; an opaque surface has no other side, but its own index decides how strong its mirror is.
  MediumIndex to = index_in(scene, result.medium_after, band, ior);
  if (boundary.opaque && material.fresnel) to = index_of(material, band, ior);
  result.index = {from.ior, to.ior, from.ior_minus_one, to.ior_minus_one};
  const Refraction refraction = bend(scene.paper, surface, direction, result.index, result.facing_normal);
  const FresnelShares fresnel_shares = fresnel(result.index, refraction);
  result.R = fresnel_shares.R;
  result.T = fresnel_shares.T;
  add_branches(scene.paper, hit, direction, boundary, shares_of(scene, boundary), refraction, result);
}

double ior_in(const Scene& scene, const MediumSet& media, std::uint32_t band) {
  return index_in(scene, media.dominant(scene), band, IorSource::band).ior;
}

bool splits_into_bands(const Scene& scene, const PathState& path, const Interaction& event) {
  if (path.band_chosen || path.ior == IorSource::camera || !event.transmit.exists) return false;
  return is_dispersive(scene, event.medium_before) || is_dispersive(scene, event.medium_after);
}

Arrival advance(const World& world, const PathState& path) {
  const Scene& scene = world.scene;
  Arrival arrival;
  arrival.media = path.media;
  Ray ray = path.ray;
  Departures left = path.departures;
  while (true) {
    const std::uint32_t medium = arrival.media.dominant(scene);
    const Rgb absorption = medium == kAir ? Rgb{} : scene.material_of(medium).absorption_per_m;
    if (!world.intersector.closest(ray, left, arrival.hit)) {
      arrival.escaped = true;
      arrival.distance = kInfinity;
      arrival.transmittance *= transmittance(absorption, kInfinity);
      return arrival;
    }
    arrival.distance += arrival.hit.t;
    arrival.transmittance *= transmittance(absorption, arrival.hit.t);
    interact(scene, incidence_of(path, arrival), arrival.event);
    if (!arrival.event.passes) return arrival;

    // Walk straight through what changes nothing.
    ray.origin = arrival.hit.point;
    left = arrival.event.transmit.departures;
    arrival.media = arrival.event.transmit.media;
  }
}

}  // namespace vitrail
