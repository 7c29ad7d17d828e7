/// The light side: what photons bring where, and that their ledger closes.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "photon/caustic_pass.h"

namespace vitrail {
namespace {

constexpr Vec3 kDown{0, -1, 0};

SceneBuilder floor_scene() {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(diffuse(0.8)));
  builder.scene.lights.push_back({"sun", DirectionalLight{kDown, {2, 3, 5}, 0}});
  builder.scene.settings.photons = 100000;
  builder.scene.settings.gather_radius_m = 0.05;
  builder.scene.settings.seed = 1;
  return builder;
}

PhotonMaps maps_of(const Scene& scene, unsigned threads = 1) {
  SilentMonitor monitor;
  const Intersector intersector(scene);
  return make_caustic_maps({scene, intersector}, {threads, monitor});
}

void expect_ledger_closed(const Ledger& ledger) {
  EXPECT_GT(largest_channel(ledger.emitted), 0);
  EXPECT_LT(ledger.closure(), 1e-9);  // the contract; in doubles it is about 1e-13
}

/// A clear ball without Fresnel loses nothing: the flux through its silhouette, E pi r^2, arrives on the floor, less
/// what leaves the ball level or upwards.
TEST(Photons, OfABallBringTheFluxOfItsSilhouette) {
  SceneBuilder builder = floor_scene();
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(glass(1.5)));
  const Ledger ledger = maps_of(builder.scene).statistics.ledger;
  expect_ledger_closed(ledger);
  const Rgb expected{2 * kPi, 3 * kPi, 5 * kPi};
  for (int c = 0; c < 3; ++c) {
    // Every photon of the disc meets the ball, and all carry the same: the sum is exact to rounding.
    EXPECT_NEAR(ledger.emitted[c], expected[c], 1e-9);
    EXPECT_NEAR(ledger.stored[c] + ledger.escaped[c], expected[c], 1e-9);
    EXPECT_GT(ledger.stored[c], 0.99 * expected[c]);
  }
}

/// A pane of t per face passes t squared, in each channel.
TEST(Photons, ThroughATintedPaneCarryTheSquareOfItsTint) {
  SceneBuilder builder = floor_scene();
  builder.add("pane", BoxShape{{-1, 1, -1}, {1, 1.1, 1}, {}}, builder.add(glass(1.5, {0.9, 0.3, 0.1})));
  const Ledger ledger = maps_of(builder.scene).statistics.ledger;
  expect_ledger_closed(ledger);
  EXPECT_NEAR(ledger.stored.r, 4 * 2 * 0.81, 1e-9);
  EXPECT_NEAR(ledger.stored.g, 4 * 3 * 0.09, 1e-9);
  EXPECT_NEAR(ledger.stored.b, 4 * 5 * 0.01, 1e-9);
  EXPECT_NEAR(ledger.absorbed.b, 4 * 5 * 0.99, 1e-9);
}

/// With Fresnel a pane passes (1-R)/(1+R) over all bounces [O 1.1]; what is cut off is in the ledger where every branch
/// is followed.
TEST(Photons, ThroughAPaneWithFresnelCarryAllBounces) {
  SceneBuilder builder = floor_scene();
  builder.add("pane", BoxShape{{-1, 1, -1}, {1, 1.1, 1}, {}}, builder.add(glass(1.5, {1, 1, 1}, true)));
  const Ledger by_chance = maps_of(builder.scene).statistics.ledger;
  expect_ledger_closed(by_chance);
  EXPECT_NEAR(by_chance.stored.r / (4 * 2), 0.923077, 1e-5);
  EXPECT_EQ(by_chance.truncated.r, 0);

  builder.scene.settings.branch_share = 0;
  const Ledger ledger = maps_of(builder.scene).statistics.ledger;
  expect_ledger_closed(ledger);
  EXPECT_NEAR(ledger.stored.r / (4 * 2), 0.923077, 1e-4);  // the cut-off share
  EXPECT_LE(ledger.truncated.r / ledger.emitted.r, 2e-4);
  EXPECT_GT(ledger.truncated.r, 0);
}

/// Every kind of loss at once: tint, absorption, a coloured mirror, a surface that is glass and diffuse.
TEST(Photons, CloseTheirLedgerInAMixedScene) {
  SceneBuilder builder = floor_scene();
  Material amber = glass(1.6, {0.5, 0.4, 0.1}, true);
  amber.reflection = {0.3, 0.2, 0.1};
  amber.diffuse = Rgb{0.1, 0.2, 0.5};
  amber.absorption_per_m = {0.1, 1, 5};
  builder.add("amber", SphereShape{{0, 2, 0}, 1}, builder.add(amber));
  Material mirror = diffuse(0.2);
  mirror.reflection = {0.7, 0.6, 0.5};
  builder.add("mirror", BoxShape{{2, 0.5, -1}, {3, 1.5, 1}, {}}, builder.add(mirror));
  builder.scene.lights.push_back({"lamp", PointLight{{1, 4, 1}, {10, 10, 10}}});
  const Ledger ledger = maps_of(builder.scene).statistics.ledger;
  expect_ledger_closed(ledger);
  for (int c = 0; c < 3; ++c) {
    EXPECT_GT(ledger.stored[c], 0);
    EXPECT_GT(ledger.absorbed[c], 0);
    EXPECT_GT(ledger.escaped[c], 0);
  }
}

/// One ball in the shadow of another: the chart of the lower one must leave to the upper one what meets it first.
TEST(Photons, MeetEachTargetOnce) {
  SceneBuilder builder = floor_scene();
  const auto clear = builder.add(glass(1.5));
  builder.add("upper", SphereShape{{0, 5, 0}, 1}, clear);
  builder.add("lower", SphereShape{{0, 2, 0}, 1}, clear);
  const Ledger ledger = maps_of(builder.scene).statistics.ledger;
  EXPECT_NEAR(ledger.emitted.r, 2 * kPi, 1e-9);
  expect_ledger_closed(ledger);
}

/// Between two mirrors light goes on for ever; the depth limit ends it and the rest is counted as truncated.
TEST(Photons, AreTruncatedAtTheDepthLimit) {
  SceneBuilder builder = floor_scene();
  Material mirror = diffuse(0);
  mirror.reflection = {1, 1, 1};
  const auto material = builder.add(mirror);
  builder.add("below", RectangleShape{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, material);
  builder.add("above", RectangleShape{{0, 3, 0}, {1, 0, 0}, {0, 0, 1}}, material);
  builder.scene.lights = {{"lamp", PointLight{{0, 2, 0}, {1, 1, 1}}}};
  builder.scene.transport.max_reflections = 5;
  const PhotonMaps maps = maps_of(builder.scene);
  expect_ledger_closed(maps.statistics.ledger);
  EXPECT_GT(maps.statistics.ledger.truncated.r, 0.01 * maps.statistics.ledger.emitted.r);
}

/// Direct light is never stored: no glass and no mirror, no photons.
TEST(Photons, AreNotStoredWithoutASpecularBounce) {
  SceneBuilder builder = floor_scene();
  EXPECT_EQ(maps_of(builder.scene).statistics.stored, 0u);
}

TEST(Photons, OfDispersiveGlassKeepEveryChannel) {
  SceneBuilder builder = floor_scene();
  builder.scene.bands = {
      {"red", {0.5, 0, 0}, {}}, {"yellow", {0.5, 0.5, 0}, {}}, {"green", {0, 0.5, 0}, {}}, {"blue", {0, 0, 1}, {}}};
  for (Material& material : builder.scene.materials) {
    material.ior_by_band = {1, 1, 1, 1};
    material.ior_minus_one_by_band = {0, 0, 0, 0};
  }
  Material flint = glass(1.6);
  flint.ior_by_band = {1.6, 1.632, 1.664, 1.696};
  flint.ior_minus_one_by_band = {0.6, 0.632, 0.664, 0.696};
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(flint));
  const PhotonMaps maps = maps_of(builder.scene);
  expect_ledger_closed(maps.statistics.ledger);
  EXPECT_NEAR(maps.statistics.ledger.emitted.r, 2 * kPi, 1e-9);
  EXPECT_GT(maps.statistics.stored, 3.9 * 99000);
}

/// The same maps for any number of threads, to the last bit.
TEST(Photons, AreTheSameForAnyNumberOfThreads) {
  SceneBuilder builder = floor_scene();
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(glass(1.5, {1, 1, 1}, true)));
  const PhotonMaps one = maps_of(builder.scene, 1), seven = maps_of(builder.scene, 7);
  EXPECT_EQ(one.statistics.ledger.stored, seven.statistics.ledger.stored);
  for (double x : {0.0, 0.1, 0.5, 0.9}) {
    const GatherQuery query{{x, 0, 0.01}, {0, 1, 0}};
    EXPECT_GT(one.half[0]->irradiance(query).r, 0);
    EXPECT_EQ(one.half[0]->irradiance(query), seven.half[0]->irradiance(query));
    EXPECT_EQ(one.half[1]->irradiance(query), seven.half[1]->irradiance(query));
    EXPECT_NE(one.half[0]->irradiance(query), one.half[1]->irradiance(query));
  }
}

}  // namespace
}  // namespace vitrail
