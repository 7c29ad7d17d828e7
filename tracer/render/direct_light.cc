#include "render/direct_light.h"

#include "material/boundary.h"
#include "optics/absorption.h"

namespace vitrail {
namespace {

constexpr int kMostFaces = 1000;

// What is left after a way in one medium.
Rgb left_by(const Scene& scene, std::uint32_t medium, double distance) {
  return medium == kAir ? Rgb{1, 1, 1} : transmittance(scene.material_of(medium).absorption_per_m, distance);
}

// What glass lets through on the straight line to a light: the share of each face [O 1.1 row 16], and what the media
// between the faces leave.
Rgb filtered(const World& world, const ShadingPoint& at, Vec3 toward, double distance) {
  const Scene& scene = world.scene;
  Ray ray{at.point, toward};
  Departures departures = at.departures;
  MediumSet media = at.media;
  Rgb left{1, 1, 1};
  double rest = distance * (1 - 0x1p-40);
  Hit hit;
  for (int face = 0; face < kMostFaces; ++face) {
    if (!world.intersector.closest(ray, departures, hit) || hit.t >= rest)
      return left * left_by(scene, media.dominant(scene), rest);
    Boundary boundary;
    find_boundary(scene, hit, media, boundary);
    left *= left_by(scene, boundary.dominant_before, hit.t);
    for (const Crossing& crossing : hit.crossings) left *= scene.material_of(crossing.object).transmission;
    if (boundary.opaque || is_black(left)) return {};
    rest -= hit.t;
    ray.origin = hit.point;
    departures = hit.through();
    media = boundary.after;
  }
  return {};
}

// The share of a light that reaches a point: what the medium leaves, nothing, or what the glass in between lets
// through.
Rgb reaching(const World& world, const ShadingPoint& at, Vec3 toward, double distance) {
  const Scene& scene = world.scene;
  if (!scene.plan.shadow || !world.intersector.occluded({at.point, toward}, at.departures, distance))
    return left_by(scene, at.dominant, distance);
  return scene.paper.shadow_filter ? filtered(world, at, toward, distance) : Rgb{};
}

}  // namespace

DirectLight direct_light(const World& world, const ShadingPoint& at, SampleDraw draw, int samples_per_light) {
  const Scene& scene = world.scene;
  DirectLight result;
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    const Light& light = scene.lights[l];
    const int samples = is_delta(light) ? 1 : samples_per_light;
    const Stream stream = within(draw.stream, l);
    Rgb sum;
    for (int s = 0; s < samples; ++s) {
      const auto index = draw.sample * static_cast<std::uint32_t>(samples) + static_cast<std::uint32_t>(s);
      const auto u = padded_2d(stream, index);
      const Illumination from = illuminate(light, at.point, at.normal, unit_point(u[0], u[1]));
      const double cosine = dot(from.toward, at.normal);
      if (!(cosine > 0) || is_black(from.irradiance)) continue;
      if (scene.plan.shadow) ++result.shadow_rays;
      sum += from.irradiance * cosine * reaching(world, at, from.toward, from.distance);
    }
    result.irradiance += samples == 1 ? sum : sum * (1.0 / samples);
  }
  return result;
}

}  // namespace vitrail
