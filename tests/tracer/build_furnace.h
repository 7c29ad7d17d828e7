#pragma once
/// A ball of some material under a sky of radiance 1.

#include <cmath>
#include <string>

#include "build_scene.h"
#include "render/render.h"

namespace vitrail {

inline constexpr double kIndex = 1.5;

struct BodyShares {
  double d, r, t;
};

struct Body {
  BodyShares shares;
  bool fresnel;
  Roughness roughness;
  bool disperses;
  double absorption_per_m = 0;
};

inline std::string name_of(const Body& body) {
  const char* rough[] = {"smooth", "equation 8", "GGX"};
  return "d " + std::to_string(body.shares.d) + " r " + std::to_string(body.shares.r) + " t " +
         std::to_string(body.shares.t) + (body.fresnel ? ", Fresnel, " : ", ") + rough[body.roughness.index()] +
         (body.disperses ? ", dispersive" : "");
}

/// Of a look; weaker branches are left to chance, whose noise is then far below the tolerances here.
inline constexpr double kFollowed = 1e-8;

inline constexpr int kSide = 6;
inline constexpr double kHalf = 0.95;  // of the image; the ball has radius 1

/// The ball alone under the sky, seen so that every pixel's centre meets it.
inline Scene furnace(const Body& body) {
  SceneBuilder builder;
  Material material = glass(kIndex, Rgb{1, 1, 1} * body.shares.t, body.fresnel);
  material.reflection = Rgb{1, 1, 1} * body.shares.r;
  material.diffuse = Rgb{1, 1, 1} * body.shares.d;
  material.roughness = body.roughness;
  material.absorption_per_m = Rgb{1, 1, 1} * body.absorption_per_m;
  if (body.disperses) {
    builder.scene.bands = {
        {"red", {0.5, 0, 0}, {}}, {"yellow", {0.5, 0.5, 0}, {}}, {"green", {0, 0.5, 0}, {}}, {"blue", {0, 0, 1}, {}}};
    material.ior_by_band = {1.5, 1.532, 1.564, 1.596};
    material.ior_minus_one_by_band = {0.5, 0.532, 0.564, 0.596};
  }
  builder.add("body", SphereShape{{0, 0, 0}, 1}, builder.add(material));
  builder.scene.lights.push_back({"sky", EnvironmentLight{{1, 1, 1}, nullptr}});
  builder.scene.camera = {CameraKind::orthographic, {0, 0, 5}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, kHalf, kHalf};
  builder.scene.image = {kSide, kSide};
  builder.scene.plan.caustic = false;
  builder.scene.transport.max_reflections = builder.scene.transport.max_transmissions = 1000;
  builder.scene.settings.branch_share = kFollowed;
  return builder.scene;
}

/// How far from the ball's axis the centre of a pixel meets it; more than 1 if it does not.
inline double offset_of(int x, int y, int side = kSide) {
  return std::hypot(kHalf * (2 * (x + 0.5) / side - 1), kHalf * (2 * (y + 0.5) / side - 1));
}

inline Film rendered(const Scene& scene) {
  SilentMonitor monitor;
  return render(scene, {2, monitor}).film;
}

inline const Roughness kFaces[] = {NoRoughness{}, Equation8{0.5}, Ggx{0.3}};

/// Fresnel's share of the mirror at the ball's outside.
inline double mirror_share(double offset) {
  const double cos_in = std::sqrt(1 - offset * offset);
  const double cos_out = std::sqrt(1 - offset * offset / (kIndex * kIndex));
  const double s = (cos_in - kIndex * cos_out) / (cos_in + kIndex * cos_out);
  const double p = (kIndex * cos_in - cos_out) / (kIndex * cos_in + cos_out);
  return 0.5 * (s * s + p * p);
}

}  // namespace vitrail
