#include "material/boundary.h"

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
bool is_displaced(const Scene& scene, const Crossing& crossing, std::uint32_t dominant) {
  return dominant != kAir && scene.objects[dominant].priority > scene.objects[crossing.object].priority &&
         is_solid(scene.objects[crossing.object].shape);
}

const Crossing* crossing_of(const Hit& hit, std::uint32_t object) {
  for (const Crossing& c : hit.crossings)
    if (c.object == object) return &c;
  return nullptr;
}

/// Stop at the opaque surface of the highest priority among those that glass does not displace.
void find_opaque_interface(const Scene& scene, const Hit& hit, Boundary& boundary) {
  for (const Crossing& c : hit.crossings) {
    if (!is_opaque(scene, c.object) || is_displaced(scene, c, boundary.dominant_before)) continue;
    if (boundary.interface == nullptr ||
        scene.objects[c.object].priority > scene.objects[boundary.interface->object].priority)
      boundary.interface = &c;
  }
  if (boundary.interface == nullptr) return;
  boundary.opaque = true;
  boundary.object = boundary.interface->object;
  boundary.dominant_after = boundary.dominant_before;
}

/// Where glass meets glass or air: the surface belongs to the solid that begins or ends to rule here.
void find_glass_interface(const Scene& scene, const Hit& hit, Boundary& boundary) {
  const Crossing *left = crossing_of(hit, boundary.dominant_before),
                 *entered = crossing_of(hit, boundary.dominant_after);
  boundary.interface = entered != nullptr ? entered : left != nullptr ? left : &hit.crossings[0];
  if (entered != nullptr && left != nullptr && entered != left) boundary.other_interface = left;
  boundary.object = boundary.interface->object;

  // An opaque solid that was displaced begins where the glass around it ends.
  if (!is_opaque(scene, boundary.dominant_after)) return;
  boundary.opaque = true;
  boundary.other_interface = nullptr;
  boundary.object = boundary.dominant_after;
  boundary.dominant_after = boundary.dominant_before;
}

}  // namespace

void find_boundary(const Scene& scene, const Hit& hit, const MediumSet& media, Boundary& boundary) {
  // A ray that comes out has been inside, even if its way in was lost to rounding.
  boundary.before = media;
  for (const Crossing& c : hit.crossings)
    if (!c.entering && !boundary.before.contains(c.object) && scene.material_of(c.object).transmits())
      boundary.before.enter(c.object);
  boundary.dominant_before = boundary.before.dominant(scene);
  find_opaque_interface(scene, hit, boundary);
  if (boundary.opaque) return;

  boundary.after = boundary.before;
  for (const Crossing& c : hit.crossings)
    c.entering ? boundary.after.enter(c.object, c.counted) : boundary.after.leave(c.object);
  boundary.dominant_after = boundary.after.dominant(scene);
  find_glass_interface(scene, hit, boundary);
}

Shares shares_of(const Scene& scene, const Boundary& boundary) {
  const Material& own = scene.material_of(boundary.object);
  Shares shares{own.reflection, own.transmission, own.fresnel};
  if (boundary.other_interface == nullptr) return shares;
  const Material& other = scene.material_of(boundary.other_interface->object);
  for (int channel = 0; channel < 3; ++channel)
    shares.reflection[channel] = std::max(own.reflection[channel], other.reflection[channel]);
  shares.transmission = own.transmission * other.transmission;
  shares.fresnel = own.fresnel || other.fresnel;
  return shares;
}

}  // namespace vitrail
