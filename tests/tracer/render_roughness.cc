/// Rough faces seen by the camera and met by photons: the same blur, and no light gained or lost.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "photon/trace.h"
#include "render/render.h"

namespace vitrail {
namespace {

constexpr double kMedianDeg = 5.8844, kMostDeg = 15.5333;  // half and 95 % of equation 8 at lambda 0.5 [O 1.3]

Material glowing() {
  Material material = diffuse(0);
  material.emission = Rgb{1, 1, 1};
  return material;
}

Material rough_mirror(const Roughness& roughness, double share = 1) {
  Material material = diffuse(0);
  material.reflection = {share, share, share};
  material.roughness = roughness;
  return material;
}

double seen(const Scene& scene) {
  SilentMonitor monitor;
  return render(scene, {1, monitor}).film.radiance(0, 0).r;
}

/// A camera above a rough mirror, which sees the mirror image of a glowing disc of that angle above itself.
Scene disc_in_a_mirror(double radius_deg) {
  SceneBuilder builder;
  builder.add("mirror", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(rough_mirror(Equation8{0.5})));
  builder.add("glow", DiscShape{{0, 10, 0}, {0, -1, 0}, 10 * std::tan(radians(radius_deg))}, builder.add(glowing()));
  builder.scene.camera = {CameraKind::orthographic, {0, 5, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 1e-6, 1e-6};
  builder.scene.plan.caustic = false;
  builder.scene.settings.rough_samples = 4096;
  return builder.scene;
}

TEST(RoughMirror, ShowsTheCameraTheTabulatedShares) {
  // 4096 stratified samples of a step: an error of a few thousandths.
  EXPECT_NEAR(seen(disc_in_a_mirror(kMedianDeg)), 0.5, 0.005);
  EXPECT_NEAR(seen(disc_in_a_mirror(kMostDeg)), 0.95, 0.005);
}

TEST(RoughMirror, IsTheSameByManyPixelSamples) {
  Scene scene = disc_in_a_mirror(kMedianDeg);
  scene.settings.rough_samples = 1;
  scene.settings.samples = 4096;
  EXPECT_NEAR(seen(scene), 0.5, 0.01);
}

/// By the letter: photons that leave Lambert's law as it is go straight on in 1 % of cases here.
TEST(RoughMirror, SendsPhotonsTheSameWay) {
  SceneBuilder builder;
  builder.scene.paper.rough_photons_literal = true;
  builder.add("mirror", DiscShape{{0, 0, 0}, {0, 1, 0}, 1e-4}, builder.add(rough_mirror(Equation8{0.5})));
  builder.add("ceiling", PlaneShape{{0, 10, 0}, {0, -1, 0}}, builder.add(diffuse(1)));
  builder.scene.lights.push_back({"lamp", PointLight{{0, 9.9, 0}, {1, 1, 1}}});
  const Intersector intersector(builder.scene);
  const Targets targets = find_targets(builder.scene, intersector);
  const auto charts = make_charts(builder.scene, targets, 20000);
  ASSERT_EQ(charts.size(), 1u);
  const PhotonPass pass{{builder.scene, intersector}, {{0, 10, 0}}};
  const auto block = trace_photons(pass, charts[0], stream_of(1, Purpose::kEmissionPosition), 0, charts[0].count);
  double inside_median = 0, inside_most = 0;
  for (const PhotonRecord& photon : block.photons) {
    const double angle = degrees(std::atan2(std::hypot(photon.position[0], photon.position[2]), 10));
    inside_median += angle < kMedianDeg;
    inside_most += angle < kMostDeg;
  }
  const auto count = static_cast<double>(block.photons.size());
  EXPECT_GT(count, 9000);  // half of the cone around the disc misses it
  EXPECT_NEAR(inside_median / count, 0.5, 0.01);
  EXPECT_NEAR(inside_most / count, 0.95, 0.01);
  EXPECT_LT(block.ledger.closure(), 1e-9);
}

/// In a closed room that glows everywhere a body with r + t = 1 cannot be seen, whatever its roughness.
double seen_in_a_furnace(const Roughness& roughness, bool literal_sum = false) {
  SceneBuilder builder;
  Material body = glass(1.5, {1, 1, 1}, true);
  body.roughness = roughness;
  if (literal_sum) body = rough_mirror(roughness);
  builder.add("body", SphereShape{{0, 0, 0}, 1}, builder.add(body));
  builder.add("room", SphereShape{{0, 0, 0}, 20}, builder.add(glowing()));
  builder.scene.camera = {CameraKind::orthographic, {0, 0, 5}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 0.5, 0.5};
  builder.scene.plan.caustic = false;
  builder.scene.settings.samples = 16;
  builder.scene.settings.rough_samples = 3;
  builder.scene.settings.branch_share = 1e-8;
  builder.scene.paper.literal_sum = literal_sum;
  builder.scene.transport.max_reflections = 1000;
  return seen(builder.scene);
}

TEST(RoughBall, IsInvisibleInAFurnace) {
  // What chance leaves out and makes good for: branches below 1e-8 of the look.
  EXPECT_NEAR(seen_in_a_furnace(NoRoughness{}), 1, 2e-5);
  EXPECT_NEAR(seen_in_a_furnace(Equation8{0.5}), 1, 2e-5);
  EXPECT_NEAR(seen_in_a_furnace(Ggx{0.3}), 1, 2e-5);
}

TEST(RoughBall, GainsByTheLiteralSum) { EXPECT_NEAR(seen_in_a_furnace(Equation8{0.5}, true), 4.0 / 3, kFilmRounding); }

TEST(RoughBall, OfRoughnessZeroIsTheSmoothOneToTheBit) {
  EXPECT_EQ(seen_in_a_furnace(Equation8{0}), seen_in_a_furnace(NoRoughness{}));
}

}  // namespace
}  // namespace vitrail
