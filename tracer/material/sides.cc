#include "material/sides.h"

#include <algorithm>

namespace vitrail {

bool is_opaque(const Scene& scene, std::uint32_t object) {
  return object != kAir && !scene.material_of(object).transmits();
}

namespace {

bool is_solid(const Shape& shape) {
  return !std::holds_alternative<RectangleShape>(shape) && !std::holds_alternative<DiscShape>(shape) &&
         !std::holds_alternative<PlaneShape>(shape);
}

/// A solid of glass with a higher priority has displaced the opaque solid here: its surface is not there.
bool is_displaced(const Scene& scene, const Crossing& crossing, std::uint32_t ruler) {
  return ruler != kAir && scene.objects[ruler].priority > scene.objects[crossing.object].priority &&
         is_solid(scene.objects[crossing.object].shape);
}

const Crossing* crossing_of(const Hit& hit, std::uint32_t object) {
  for (const Crossing& c : hit.crossings)
    if (c.object == object) return &c;
  return nullptr;
}

/// Stop at the opaque surface of the highest priority among those that glass does not displace.
void find_opaque_owner(const Scene& scene, const Hit& hit, Sides& sides) {
  for (const Crossing& c : hit.crossings) {
    if (!is_opaque(scene, c.object) || is_displaced(scene, c, sides.ruler_before)) continue;
    if (sides.owner == nullptr || scene.objects[c.object].priority > scene.objects[sides.owner->object].priority)
      sides.owner = &c;
  }
  if (sides.owner == nullptr) return;
  sides.opaque = true;
  sides.object = sides.owner->object;
  sides.ruler_after = sides.ruler_before;
}

/// Where glass meets glass or air: the surface belongs to the solid that begins or ends to rule here.
void find_glass_owner(const Scene& scene, const Hit& hit, Sides& sides) {
  const Crossing *left = crossing_of(hit, sides.ruler_before), *entered = crossing_of(hit, sides.ruler_after);
  sides.owner = entered != nullptr ? entered : left != nullptr ? left : &hit.crossings[0];
  if (entered != nullptr && left != nullptr && entered != left) sides.partner = left;
  sides.object = sides.owner->object;

  // An opaque solid that was displaced begins where the glass around it ends.
  if (!is_opaque(scene, sides.ruler_after)) return;
  sides.opaque = true;
  sides.partner = nullptr;
  sides.object = sides.ruler_after;
  sides.ruler_after = sides.ruler_before;
}

}  // namespace

void find_sides(const Scene& scene, const Hit& hit, const MediumSet& media, Sides& sides) {
  // A ray that comes out has been inside, even if its way in was lost to rounding.
  sides.before = media;
  for (const Crossing& c : hit.crossings)
    if (!c.entering && !sides.before.contains(c.object) && scene.material_of(c.object).transmits())
      sides.before.enter(c.object);
  sides.ruler_before = sides.before.ruler(scene);
  find_opaque_owner(scene, hit, sides);
  if (sides.opaque) return;

  sides.after = sides.before;
  for (const Crossing& c : hit.crossings)
    c.entering ? sides.after.enter(c.object, c.counted) : sides.after.leave(c.object);
  sides.ruler_after = sides.after.ruler(scene);
  find_glass_owner(scene, hit, sides);
}

Shares shares_of(const Scene& scene, const Sides& sides) {
  const Material& own = scene.material_of(sides.object);
  Shares shares{own.reflection, own.transmission, own.fresnel};
  if (sides.partner == nullptr) return shares;
  const Material& other = scene.material_of(sides.partner->object);
  for (int channel = 0; channel < 3; ++channel)
    shares.reflection[channel] = std::max(own.reflection[channel], other.reflection[channel]);
  shares.transmission = own.transmission * other.transmission;
  shares.fresnel = own.fresnel || other.fresnel;
  return shares;
}

}  // namespace vitrail
