#include "optics/roughness.h"

#include <algorithm>
#include <cmath>

#include "base/frame.h"
#include "base/sine_cosine.h"

namespace vitrail {

Vec3 deflect(Vec3 direction, double lambda, Vec3 facing, const std::array<double, 3>& u) {
  if (lambda == 0) return direction;

  // Take a point on the sphere and keep the part of it across the direction.
  const double height = 1 - 2 * u[1], radius = std::sqrt(std::max(0.0, 1 - height * height));
  const auto [sine, cosine] = sine_cosine_of_turn(u[2]);
  const Vec3 mu{radius * cosine, radius * sine, height};
  const Vec3 rho = mu - direction * dot(mu, direction);
  const double gamma = u[0] * lambda / 2;
  const Vec3 bent = normalise(direction * (1 - gamma) + rho * gamma);

  const double above = dot(bent, facing);
  return above < 0 ? bent - facing * (2 * above) : bent;
}

Vec3 deflect_light(Vec3 direction, double lambda, Vec3 facing, const std::array<double, 3>& u, double keep) {
  const Vec3 bent = deflect(direction, lambda, facing, u);
  return keep * dot(direction, facing) < dot(bent, facing) ? bent : direction;
}

Vec3 ggx_normal(Vec3 toward_viewer, Vec3 normal, double alpha, double u, double v) {
  const SurfaceFrame frame = surface_frame(normal);
  const auto to_world = [&](Vec3 local) { return frame.u * local.x + frame.v * local.y + normal * local.z; };

  // Stretch the surface until it is a hemisphere of normals, and look at it from the stretched direction.
  const Vec3 view =
      normalise({alpha * dot(toward_viewer, frame.u), alpha * dot(toward_viewer, frame.v), dot(toward_viewer, normal)});
  const SurfaceFrame across = surface_frame(view);

  // Choose a point on the visible part: a disc whose lower half is squeezed to where the hemisphere ends. The squeeze
  // is along the direction in which the hemisphere leans.
  const Vec3 flat = cross({0, 0, 1}, view);
  const Vec3 sideways = length_squared(flat) > 0 ? normalise(flat) : across.u;
  const Vec3 upwards = cross(view, sideways);
  const auto [sine, cosine] = sine_cosine_of_turn(v);
  const double r = std::sqrt(u), a = r * cosine, lean = 0.5 * (1 + view.z);
  const double b = (1 - lean) * std::sqrt(std::max(0.0, 1 - a * a)) + lean * r * sine;
  const Vec3 chosen = sideways * a + upwards * b + view * std::sqrt(std::max(0.0, 1 - a * a - b * b));

  // Undo the stretching.
  return normalise(to_world({alpha * chosen.x, alpha * chosen.y, std::max(1e-300, chosen.z)}));
}

}  // namespace vitrail
