/// Indirect light against the closed form of a white room: every bounce multiplies by the albedo.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "render/render.h"

namespace vitrail {
namespace {

/// A camera and a lamp in the middle of a hollow sphere of radius 1. Direct irradiance I everywhere on the wall, and
/// with albedo d all bounces together I / (1 - d) [furnace of a sphere].
SceneBuilder hollow_sphere(double albedo, int final_gather_rays) {
  SceneBuilder builder;
  builder.add("wall", SphereShape{{0, 0, 0}, 1}, builder.add(diffuse(albedo)));
  builder.scene.lights.push_back({"lamp", PointLight{{0, 0, 0}, {1, 2, 4}}});
  builder.scene.camera = {CameraKind::perspective, {0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 0.3, 0.3};
  builder.scene.image = {8, 8};
  builder.scene.transport.indirect = Indirect::photons;
  builder.scene.settings.photons = 400000;
  builder.scene.settings.gather_radius_m = 0.025;  // times four: 0.1 m, 0.25 % of the sphere
  builder.scene.settings.final_gather_rays = final_gather_rays;
  builder.scene.settings.seed = 1;
  return builder;
}

Rgb mean_indirect(const Scene& scene) {
  SilentMonitor monitor;
  const Film film = render(scene, {2, monitor}).film;
  Rgb sum;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) sum += film.layer(Layer::indirect_light, x, y);
  }
  return sum * (1.0 / 64);
}

void expect_all_bounces(double albedo, int final_gather_rays) {
  const Rgb found = mean_indirect(hollow_sphere(albedo, final_gather_rays).scene);
  for (int c = 0; c < 3; ++c) {
    const double direct = 1 << c, indirect = direct * albedo / (1 - albedo);
    // 1 % from photon noise: 500 to 1000 photons in each of some independent discs; and R^2/8 from the sphere's
    // curvature.
    EXPECT_NEAR(found[c] / (albedo / kPi * indirect), 1, 0.015) << albedo << " " << final_gather_rays;
  }
}

TEST(Indirect, IsAllBouncesOfAWhiteRoomFromTheMap) {
  expect_all_bounces(0.5, 0);
  expect_all_bounces(0.8, 0);
}

/// The same over a sixth of the wall, where a million photons leave less noise: 1 / (1 - d) within half a percent.
TEST(Indirect, IsAllBouncesOfAWhiteRoomWithinHalfAPercent) {
  for (const double albedo : {0.5, 0.8}) {
    SceneBuilder builder = hollow_sphere(albedo, 0);
    builder.scene.camera.half_width = builder.scene.camera.half_height = 1;
    builder.scene.settings.photons = 1000000;
    builder.scene.settings.gather_radius_m = 0.015;  // a disc of 0.06 m on the sphere: its cap is 0.09 % larger
    const double truth = albedo / kPi * albedo / (1 - albedo);
    EXPECT_NEAR(mean_indirect(builder.scene).r / truth, 1, 0.005) << albedo;
  }
}

TEST(Indirect, IsAllBouncesOfAWhiteRoomByFinalGathering) {
  expect_all_bounces(0.5, 32);
  expect_all_bounces(0.8, 32);
}

/// A clear ball of index 1 in the middle changes nothing, nor do coloured walls mix channels.
TEST(Indirect, PassesThroughGlass) {
  for (int rays : {0, 32}) {
    SceneBuilder builder = hollow_sphere(0.5, rays);
    builder.add("ghost", SphereShape{{0.2, 0, -0.5}, 0.25}, builder.add(glass(1)));
    const Rgb found = mean_indirect(builder.scene);
    // Direct light does not pass the ball, the caustic map gives it back; the gathered sum is the same.
    EXPECT_NEAR(found.r / (0.5 / kPi), 1, 0.02) << rays;
  }
}

TEST(Indirect, IsTheSameForAnyNumberOfThreads) {
  Scene scene = hollow_sphere(0.5, 4).scene;
  scene.settings.photons = 20000;
  SilentMonitor monitor;
  const Film one = render(scene, {1, monitor}).film, seven = render(scene, {7, monitor}).film;
  for (int x = 0; x < 8; ++x) EXPECT_EQ(one.radiance(x, 3), seven.radiance(x, 3));
}

}  // namespace
}  // namespace vitrail
