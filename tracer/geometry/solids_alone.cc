#include "geometry/solids_alone.h"

#include <algorithm>
#include <numeric>

namespace vitrail {
namespace {

// Whether a shape is one solid that a ray inside it cannot leave unseen: not a sheet, and not a mesh of triangles.
bool encloses(const Primitive& primitive) {
  return !std::holds_alternative<Plane>(primitive) && !std::holds_alternative<Rectangle>(primitive) &&
         !std::holds_alternative<Disc>(primitive) && !std::holds_alternative<Mesh>(primitive);
}

// A box with a gap around it that no rounding closes.
Bounds with_gap(const Bounds& box) {
  const double gap = std::max(largest_coordinate(box.min), largest_coordinate(box.max)) * 0x1p-20;
  return {box.min - Vec3{gap, gap, gap}, box.max + Vec3{gap, gap, gap}};
}

bool meet(const Bounds& a, const Bounds& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

// Whether a box is within a ball or a box, like furniture in a room: it then meets no face of that.
bool surrounds(const Primitive& primitive, const Bounds& box) {
  if (!std::holds_alternative<Sphere>(primitive) && !std::holds_alternative<Box>(primitive)) return false;
  for (int corner = 0; corner < 8; ++corner)
    if (!contains(primitive, {corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                              corner & 4 ? box.max.z : box.min.z}))
      return false;
  return true;
}

}  // namespace

std::vector<bool> solids_alone(const std::vector<Primitive>& primitives, const std::vector<std::uint32_t>& left_out) {
  std::vector<bool> asked(primitives.size(), true), alone(primitives.size(), false);
  for (const std::uint32_t object : left_out) asked[object] = false;
  std::vector<std::uint32_t> held;
  std::vector<Bounds> boxes;
  for (std::uint32_t object = 0; object < primitives.size(); ++object) {
    if (!asked[object]) continue;
    held.push_back(object);
    boxes.push_back(with_gap(vitrail::bounds(primitives[object])));
  }

  // Sort along x, so that each box is compared with those beside it alone.
  std::vector<std::size_t> order(held.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return boxes[a].min.x < boxes[b].min.x; });
  for (const std::uint32_t object : held) alone[object] = encloses(primitives[object]);
  const auto disturb = [&](std::size_t one, std::size_t other) {
    if (!surrounds(primitives[held[other]], boxes[one])) alone[held[one]] = false;
  };
  for (std::size_t a = 0; a < order.size(); ++a) {
    const Bounds& box = boxes[order[a]];
    for (std::size_t b = a + 1; b < order.size() && boxes[order[b]].min.x <= box.max.x; ++b) {
      if (!meet(box, boxes[order[b]])) continue;
      disturb(order[a], order[b]);
      disturb(order[b], order[a]);
    }
  }
  return alone;
}

}  // namespace vitrail
