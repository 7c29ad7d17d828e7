#include "material/surface.h"

#include <algorithm>

#include "optics/absorption.h"
#include "optics/fresnel.h"
#include "optics/refract.h"

namespace vitrail {

namespace {

struct MediumIndex {
  double ior = 1, ior_minus_one = 0;
};

MediumIndex index_of(const Scene& scene, std::uint32_t object, std::uint32_t band, bool ior_of_camera) {
  if (object == kAir || !scene.material_of(object).transmits()) return {};
  const Material& material = scene.material_of(object);
  if (ior_of_camera) return {material.camera_ior, material.camera_ior - 1};
  return {material.ior_by_band[band], material.ior_minus_one_by_band[band]};
}

bool is_opaque(const Scene& scene, std::uint32_t object) {
  return object != kAir && !scene.material_of(object).transmits();
}

bool is_solid(const Shape& shape) {
  return !std::holds_alternative<RectangleShape>(shape) && !std::holds_alternative<DiscShape>(shape) &&
         !std::holds_alternative<PlaneShape>(shape);
}

/// A solid of glass with a higher priority has displaced the opaque solid here: its surface is not there.
bool is_displaced(const Scene& scene, const Crossing& crossing, const MediumSet& media) {
  const std::uint32_t ruler = media.ruler(scene);
  return ruler != kAir && is_solid(scene.objects[crossing.object].shape) &&
         scene.objects[ruler].priority > scene.objects[crossing.object].priority;
}

/// The media on both sides of a hit, and whose surface it is.
struct Sides {
  MediumSet before, after;
  const Crossing* owner = nullptr;    // the surface that acts
  const Crossing* partner = nullptr;  // the other solid of glass that touches here, if any
  bool opaque = false;
};

/// Cross every surface of the hit at once: sets, and not the order of arrival, decide what is on the other side.
Sides cross_all(const Scene& scene, const Hit& hit, const MediumSet& media) {
  Sides sides{media, {}, nullptr, nullptr, false};
  for (const Crossing& c : hit.crossings)
    if (!c.entering && scene.material_of(c.object).transmits() && !sides.before.contains(c.object))
      sides.before.enter(c.object);  // the way in was lost to rounding: a ray that comes out has been inside

  sides.after = sides.before;
  for (const Crossing& c : hit.crossings) {
    // Stop at an opaque surface, unless higher glass displaces it; then only remember to be inside it.
    if (is_opaque(scene, c.object) && !is_displaced(scene, c, sides.before)) {
      const bool first =
          !sides.opaque || scene.objects[c.object].priority > scene.objects[sides.owner->object].priority;
      if (first) sides.owner = &c;
      sides.opaque = true;
    }
    c.entering ? sides.after.enter(c.object, c.counted) : sides.after.leave(c.object);
  }
  return sides;
}

const Crossing* crossing_of(const Hit& hit, std::uint32_t object) {
  for (const Crossing& c : hit.crossings)
    if (c.object == object) return &c;
  return nullptr;
}

/// Where glass meets glass or air: the surface belongs to the solid that begins or ends to rule here.
void find_owner(const Scene& scene, const Hit& hit, Sides& sides) {
  const std::uint32_t from = sides.before.ruler(scene), to = sides.after.ruler(scene);
  const Crossing *left = crossing_of(hit, from), *entered = crossing_of(hit, to);
  sides.owner = entered != nullptr ? entered : left;
  if (sides.owner == nullptr) sides.owner = &hit.crossings[0];
  if (entered != nullptr && left != nullptr && entered != left) sides.partner = left;

  // An opaque solid that was displaced begins where the glass around it ends.
  if (is_opaque(scene, to)) {
    sides.opaque = true;
    sides.partner = nullptr;
  }
}

/// The shares of a surface. Two solids in contact act like their two faces at no distance: tints multiply, the stronger
/// mirror wins; this is the same from either side and never makes light.
struct Shares {
  Rgb reflection, transmission;
  bool fresnel = false;
};

Shares shares_of(const Scene& scene, const Sides& sides, std::uint32_t material) {
  const Material& own = scene.materials[material];
  Shares shares{own.reflection, own.transmission, own.fresnel};
  if (sides.partner == nullptr) return shares;
  const Material& other = scene.material_of(sides.partner->object);
  for (int channel = 0; channel < 3; ++channel)
    shares.reflection[channel] = std::max(own.reflection[channel], other.reflection[channel]);
  shares.transmission = own.transmission * other.transmission;
  shares.fresnel = own.fresnel || other.fresnel;
  return shares;
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
void add_branches(const Paper& paper, const Hit& hit, Vec3 direction, const Sides& sides, const Shares& shares,
                  const Refraction& refraction, Interaction& result) {
  const Rgb pool = shares.reflection + shares.transmission;
  const bool transmits = !sides.opaque && !refraction.total;
  Rgb mirrored = shares.fresnel ? pool * result.R : shares.reflection;
  Rgb refracted = shares.fresnel ? pool * result.T : shares.transmission;

  // Under total reflection the whole pool is mirrored, unless the paper is read by the letter [O 1.1 row 8].
  if (!sides.opaque && refraction.total) {
    result.total_internal_reflection = true;
    mirrored = paper.tir_drop ? shares.reflection : pool;
  }
  if (!is_black(mirrored))
    result.reflect = {true, reflect(direction, result.facing_normal), mirrored, hit.back(), sides.before};
  if (transmits && !is_black(refracted))
    result.transmit = {true, refraction.direction, refracted, hit.through(), sides.after};
}

}  // namespace

Interaction interact(const Scene& scene, const Hit& hit, Vec3 direction, const MediumSet& media, std::uint32_t band,
                     bool ior_of_camera) {
  Interaction result;
  Sides sides = cross_all(scene, hit, media);
  if (!sides.opaque) find_owner(scene, hit, sides);
  result.medium_before = sides.before.ruler(scene);
  result.medium_after = sides.opaque ? result.medium_before : sides.after.ruler(scene);

  // Go straight on where nothing changes: the same ruler, or two pieces of one glass.
  const bool same = result.medium_before == result.medium_after;
  const bool same_glass = sides.partner != nullptr &&
                          scene.objects[result.medium_before].material == scene.objects[result.medium_after].material;
  if (!sides.opaque && (same || same_glass)) {
    result.passes = true;
    result.transmit = {true, direction, {1, 1, 1}, hit.through(), sides.after};
    return result;
  }

  // Describe the surface.
  const Crossing& surface = *sides.owner;
  result.object = sides.opaque && !is_opaque(scene, surface.object) ? sides.after.ruler(scene) : surface.object;
  result.material = scene.objects[result.object].material;
  const Material& material = scene.materials[result.material];
  result.entering = surface.entering;
  result.diffuse = sides.partner == nullptr ? texture_at(material.diffuse, surface.s, surface.q) : Rgb{};
  result.emission = texture_at(material.emission, surface.s, surface.q);
  result.roughness = material.roughness;

  // Bend the light; an opaque surface has no other side, but its own index decides how strong its mirror is.
  const MediumIndex from = index_of(scene, result.medium_before, band, ior_of_camera);
  MediumIndex to = index_of(scene, result.medium_after, band, ior_of_camera);
  if (sides.opaque && material.fresnel)
    to = ior_of_camera ? MediumIndex{material.camera_ior, material.camera_ior - 1}
                       : MediumIndex{material.ior_by_band[band], material.ior_minus_one_by_band[band]};
  const IndexPair index{from.ior, to.ior, from.ior_minus_one, to.ior_minus_one};
  const Refraction refraction = bend(scene.paper, surface, direction, index, result.facing_normal);
  const FresnelShares fresnel_shares = fresnel(index, refraction);
  result.ior_before = from.ior;
  result.ior_after = to.ior;
  result.R = fresnel_shares.R;
  result.T = fresnel_shares.T;
  add_branches(scene.paper, hit, direction, sides, shares_of(scene, sides, result.material), refraction, result);
  return result;
}

double ior_in(const Scene& scene, const MediumSet& media, std::uint32_t band) {
  return index_of(scene, media.ruler(scene), band, false).ior;
}

Arrival advance(const Scene& scene, const Intersector& intersector, const Ray& start, const Departures& departures,
                const MediumSet& media, std::uint32_t band, bool ior_of_camera) {
  Arrival arrival;
  arrival.media = media;
  Ray ray = start;
  Departures left = departures;
  while (true) {
    const std::uint32_t medium = arrival.media.ruler(scene);
    const Rgb absorption = medium == kAir ? Rgb{} : scene.material_of(medium).absorption_per_m;
    if (!intersector.closest(ray, left, arrival.hit)) {
      arrival.escaped = true;
      arrival.distance = kInfinity;
      arrival.transmittance *= transmittance(absorption, kInfinity);
      return arrival;
    }
    arrival.distance += arrival.hit.t;
    arrival.transmittance *= transmittance(absorption, arrival.hit.t);
    arrival.event = interact(scene, arrival.hit, ray.direction, arrival.media, band, ior_of_camera);
    if (!arrival.event.passes) return arrival;

    // Walk straight through what changes nothing.
    ray.origin = arrival.hit.point;
    left = arrival.event.transmit.departures;
    arrival.media = arrival.event.transmit.media;
  }
}

}  // namespace vitrail
