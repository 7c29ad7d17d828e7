#include "render/polygon.h"

#include <cmath>

namespace vitrail {
namespace {

// Keep the side of a line where `height` is not negative. Two polygons that share an edge are cut in the same place.
template <typename Height>
Polygon cut(const Polygon& polygon, const Height& height) {
  Polygon kept;
  for (int k = 0; k < polygon.size; ++k) {
    const Polygon::Corner from = polygon.corners[k], to = polygon.corners[(k + 1) % polygon.size];
    const double h = height(from), g = height(to);
    if (h >= 0) kept.add(from);
    if ((h >= 0) != (g >= 0)) {
      const double s = h / (h - g);
      kept.add({from.x + (to.x - from.x) * s, from.y + (to.y - from.y) * s});
    }
  }
  return kept;
}

}  // namespace

Polygon between_columns(const Polygon& polygon, double low, double high) {
  const Polygon right = cut(polygon, [&](Polygon::Corner c) { return c.x - low; });
  return cut(right, [&](Polygon::Corner c) { return high - c.x; });
}

Polygon between_rows(const Polygon& polygon, double low, double high) {
  const Polygon below = cut(polygon, [&](Polygon::Corner c) { return c.y - low; });
  return cut(below, [&](Polygon::Corner c) { return high - c.y; });
}

AreaAndMiddle area_of(const Polygon& polygon) {
  AreaAndMiddle result;
  if (polygon.size == 0) return result;

  // Add up the triangles from the first corner, which is near all others.
  const Polygon::Corner o = polygon.corners[0];
  double twice = 0, x = 0, y = 0;
  for (int k = 1; k + 1 < polygon.size; ++k) {
    const double ax = polygon.corners[k].x - o.x, ay = polygon.corners[k].y - o.y;
    const double bx = polygon.corners[k + 1].x - o.x, by = polygon.corners[k + 1].y - o.y;
    const double part = ax * by - bx * ay;
    twice += part;
    x += part * (ax + bx) / 3;
    y += part * (ay + by) / 3;
  }
  if (twice != 0) {
    result.area = std::abs(twice) / 2;
    result.middle = {o.x + x / twice, o.y + y / twice};
    return result;
  }
  for (int k = 0; k < polygon.size; ++k) {
    result.middle.x += polygon.corners[k].x / polygon.size;
    result.middle.y += polygon.corners[k].y / polygon.size;
  }
  return result;
}

}  // namespace vitrail
