#include "light/window.h"

#include <cmath>
#include <limits>

#include "light/sampling.h"

namespace vitrail {

double Window::area() const { return (round ? M_PI : 4) * length(u) * length(v); }

Window window_on(const Target& target, Vec3 direction) {
  const SurfaceFrame frame = surface_frame(direction);
  const Window disc{target.bound.center, frame.u * target.bound.radius, frame.v * target.bound.radius, true};

  // Project the eight corners of the box.
  double low[2], high[2];
  for (int a = 0; a < 2; ++a) {
    low[a] = std::numeric_limits<double>::infinity();
    high[a] = -low[a];
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{corner & 1 ? target.box.max.x : target.box.min.x, corner & 2 ? target.box.max.y : target.box.min.y,
                 corner & 4 ? target.box.max.z : target.box.min.z};
    const Vec3 from_center = p - target.bound.center;
    const double along[2] = {dot(from_center, frame.u), dot(from_center, frame.v)};
    for (int a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], along[a]);
      high[a] = std::max(high[a], along[a]);
    }
  }
  const Vec3 center = target.bound.center + frame.u * ((low[0] + high[0]) / 2) + frame.v * ((low[1] + high[1]) / 2);
  const Window rectangle{center, frame.u * ((high[0] - low[0]) / 2), frame.v * ((high[1] - low[1]) / 2), false};
  return rectangle.area() < disc.area() ? rectangle : disc;
}

Vec3 upstream_of(Vec3 point, Vec3 direction, const BoundingSphere& surroundings) {
  // A margin of a thousandth keeps the start off the surfaces; scaling the scene scales it.
  const double start = dot(surroundings.center, direction) - 1.001 * surroundings.radius;
  return point + direction * std::min(0.0, start - dot(point, direction));
}

namespace {

// How far upstream of the point light has crossed the plane; negative if it will cross it downstream, NaN if never.
double way_from(const PlaneShape& plane, Vec3 point, Vec3 direction) {
  const double climb = dot(direction, plane.normal);
  const double way = dot(point - plane.point, plane.normal) / climb;
  return std::isinf(way) ? std::numeric_limits<double>::quiet_NaN() : way;
}

}  // namespace

Vec3 before_planes(Vec3 point, Vec3 direction, const Surroundings& surroundings) {
  for (const PlaneShape& plane : surroundings.planes) {
    const double way = way_from(plane, point, direction);
    if (way >= 0) point = point - direction * (way + 0.001 * (way + surroundings.radius));
  }
  return point;
}

std::vector<PlaneShape> planes_before(const Window& window, Vec3 direction, const std::vector<PlaneShape>& planes) {
  std::vector<PlaneShape> crossed;
  for (const PlaneShape& plane : planes) {
    const double reach = std::abs(dot(window.u, plane.normal)) + std::abs(dot(window.v, plane.normal));
    const double farthest = way_from(plane, window.center, direction) + reach / std::abs(dot(direction, plane.normal));
    if (farthest >= 0) crossed.push_back(plane);
  }
  return crossed;
}

}  // namespace vitrail
