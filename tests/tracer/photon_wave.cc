/// Many photons at once against one by one.

#include "photon/wave/photon_wave.h"

#include <gtest/gtest.h>

#include "build_scene.h"

namespace vitrail {
namespace {

void expect_the_same_light(const Scene& scene, double rounding = 1e-12) {
  const Intersector intersector(scene);
  const Targets targets = find_targets(scene, intersector);
  const PhotonPass pass{{scene, intersector}, {targets.surroundings.center}};
  for (const Chart& chart : make_charts(scene, targets, 4000)) {
    const Stream stream = stream_of(1, Purpose::kEmissionPosition);
    const PhotonBlock quick = trace_photons(pass, chart, stream, 0, chart.count);
    const PhotonBlock plain = trace_photons(pass, chart, stream, 0, chart.count, Strategy::tree);
    ASSERT_EQ(quick.photons.size(), plain.photons.size());
    for (int c = 0; c < 3; ++c) {
      // Both ways round each step differently, and 4000 photons are summed.
      const double size = rounding * plain.ledger.emitted[c];
      EXPECT_NEAR(quick.ledger.emitted[c], plain.ledger.emitted[c], size);
      EXPECT_NEAR(quick.ledger.stored[c], plain.ledger.stored[c], size);
      EXPECT_NEAR(quick.ledger.absorbed[c], plain.ledger.absorbed[c], size);
      EXPECT_NEAR(quick.ledger.escaped[c], plain.ledger.escaped[c], size);
      EXPECT_NEAR(quick.ledger.truncated[c], plain.ledger.truncated[c], size);
    }
    EXPECT_LT(quick.ledger.closure(), 1e-12);
  }
}

SceneBuilder floor_and_sun() {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(diffuse(0.8)));
  builder.scene.lights.push_back({"sun", DirectionalLight{normalise({0.2, -1, 0.1}), {2, 3, 5}, 0}});
  builder.scene.lights.push_back({"lamp", PointLight{{1, 4, 1}, {1, 2, 3}}});
  return builder;
}

TEST(PhotonWave, FollowsABallAsTheGeneralWayDoes) {
  SceneBuilder builder = floor_and_sun();
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(glass(1.5, {0.9, 0.8, 0.7}, true)));
  ASSERT_TRUE(PhotonWave::suits(builder.scene));
  expect_the_same_light(builder.scene);
}

TEST(PhotonWave, FollowsMixedShapesAsTheGeneralWayDoes) {
  SceneBuilder builder = floor_and_sun();
  Material amber = glass(1.6, {0.5, 0.4, 0.1}, true);
  amber.reflection = {0.3, 0.2, 0.1};
  amber.diffuse = Rgb{0.1, 0.2, 0.5};
  amber.absorption_per_m = {0.1, 1, 5};
  const auto amber_id = builder.add(amber);
  builder.add("box", BoxShape{{-1, 0.5, -1}, {0, 1.5, 0}, turned()}, amber_id);
  builder.add("prism", PrismShape{{{1, 1}, {2, 1}, {1.5, 2}}, 1, {}}, amber_id);
  Material mirror = diffuse(0.2);
  mirror.reflection = {0.7, 0.6, 0.5};
  const auto mirror_id = builder.add(mirror);
  builder.add("mirror", RectangleShape{{0, 1.2, 2}, {1, 0, 0}, {0, 1, 0.3}}, mirror_id);
  builder.add("disc", DiscShape{{0, 3, 0}, {0, 1, 0}, 0.5}, mirror_id);
  expect_the_same_light(builder.scene);
}

/// Few reflections and few crossings, and light that is sent back totally by a prism and mirrored by its faces.
TEST(PhotonWave, CountsFacesAsTheGeneralWayDoes) {
  SceneBuilder builder = floor_and_sun();
  Material shiny = glass(1.7, {0.6, 0.6, 0.6});
  shiny.reflection = {0.4, 0.4, 0.4};
  builder.add("prism", PrismShape{{{1, 1}, {2, 1}, {1.5, 2}}, 1, {}}, builder.add(shiny));
  for (const bool drops : {false, true}) {
    for (const auto& [reflections, transmissions] : {std::pair{1, 64}, std::pair{8, 3}}) {
      builder.scene.paper.tir_drop = drops;
      builder.scene.transport.max_reflections = reflections;
      builder.scene.transport.max_transmissions = transmissions;
      expect_the_same_light(builder.scene);
    }
  }
}

/// A bubble in a block, a ball on the floor, opaque things in glass: what the wave hands over to the tree.
TEST(PhotonWave, HandsOverWhatIsNotPlain) {
  SceneBuilder builder = floor_and_sun();
  const auto clear = builder.add(glass(1.5, {1, 1, 1}, true));
  builder.add("block", BoxShape{{-1, 0, -1}, {1, 2, 1}, {}}, clear);
  builder.add("bubble", SphereShape{{0, 1, 0}, 0.5}, builder.add(glass(1.2)), 1);
  builder.add("stone", SphereShape{{0.7, 0.3, 0.7}, 0.2}, 0);
  expect_the_same_light(builder.scene);
}

TEST(PhotonWave, SplitsBandsAsTheGeneralWayDoes) {
  SceneBuilder builder = floor_and_sun();
  builder.scene.bands = {{"red", {0.5, 0, 0}, {}}, {"yellow", {0.5, 0.5, 0}, {}}, {"blue", {0, 0.5, 1}, {}}};
  builder.scene.materials[0].ior_by_band = {1, 1, 1};
  builder.scene.materials[0].ior_minus_one_by_band = {0, 0, 0};
  Material flint = glass(1.6, {0.9, 0.9, 0.9}, true);
  flint.ior_by_band = {1.6, 1.632, 1.664};
  flint.ior_minus_one_by_band = {0.6, 0.632, 0.664};
  const auto flint_id = builder.add(flint);
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, flint_id);
  builder.add("second", SphereShape{{2.2, 1, 0}, 0.8}, flint_id);
  expect_the_same_light(builder.scene);
}

/// Rough glass that mirrors, tints and scatters, and a rough mirror: by equation 8 and by facets, by Fresnel and not.
TEST(PhotonWave, ScattersAtRoughFacesAsTheGeneralWayDoes) {
  for (const Roughness& roughness : {Roughness{Equation8{0.3}}, Roughness{Ggx{0.1}}, Roughness{Ggx{0.6}}}) {
    for (const bool fresnel : {false, true}) {
      SceneBuilder builder = floor_and_sun();
      Material frosted = glass(1.5, {0.8, 0.7, 0.6}, fresnel);
      frosted.reflection = {0.1, 0.1, 0.2};
      frosted.diffuse = Rgb{0.1, 0.1, 0.1};
      frosted.roughness = roughness;
      builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(frosted));
      builder.add("prism", PrismShape{{{1, 1}, {2, 1}, {1.5, 2}}, 1, {}}, 1);
      Material brushed = diffuse(0.2);
      brushed.reflection = {0.7, 0.6, 0.5};
      brushed.roughness = roughness;
      brushed.fresnel = fresnel;
      brushed.ior_by_band = {1.4};
      brushed.ior_minus_one_by_band = {0.4};
      builder.add("mirror", RectangleShape{{0, 1.2, 2}, {1, 0, 0}, {0, 1, 0.3}}, builder.add(brushed));
      ASSERT_TRUE(PhotonWave::suits(builder.scene));
      for (const bool literal : {false, true}) {
        builder.scene.paper.rough_photons_literal = literal;
        SCOPED_TRACE(std::to_string(roughness.index()) + (fresnel ? " by Fresnel" : "") + (literal ? " literal" : ""));
        expect_the_same_light(builder.scene);
      }
    }
  }
}

/// A ball of glass with so many bands, which differ in nothing but their index.
Scene ball_of_bands(int count) {
  SceneBuilder builder = floor_and_sun();
  builder.scene.bands.clear();
  Material flint = glass(1.6);
  flint.ior_by_band.clear();
  flint.ior_minus_one_by_band.clear();
  for (int band = 0; band < count; ++band) {
    const double share = 1.0 / count;
    builder.scene.bands.push_back({"band", {share, share, share}, {}});
    flint.ior_by_band.push_back(1.6 + 0.1 * share * band);
    flint.ior_minus_one_by_band.push_back(0.6 + 0.1 * share * band);
  }
  builder.scene.materials[0].ior_by_band.assign(static_cast<std::size_t>(count), 1);
  builder.scene.materials[0].ior_minus_one_by_band.assign(static_cast<std::size_t>(count), 0);
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(flint));
  return builder.scene;
}

/// Sixty-four balls side by side, some of which touch: more objects than any vector of rays meets.
TEST(PhotonWave, FollowsManyBallsAsTheGeneralWayDoes) {
  SceneBuilder builder = floor_and_sun();
  const auto clear = builder.add(glass(1.5, {0.9, 0.9, 0.9}, true));
  for (int i = 0; i < 64; ++i) {
    const double x = i % 8, z = i / 8;
    builder.add("ball", SphereShape{{x, 1 + 0.1 * x, z}, i % 16 == 0 ? 0.6 : 0.4}, clear);
  }
  ASSERT_TRUE(PhotonWave::suits(builder.scene));
  expect_the_same_light(builder.scene);
}

/// Each photon follows some of many bands, and both ways the same ones. Sixteen times as many branches are summed.
TEST(PhotonWave, TakesTheBandsThatTheGeneralWayTakes) {
  for (const int bands : {17, 32, 100}) {
    Scene scene = ball_of_bands(bands);
    expect_the_same_light(scene, 1e-11);
    scene.lights = {{"lamp", AreaLight{DiscShape{{0, 5, 0}, {0, -1, 0}, 0.3}, false, {1, 1, 1}, {}}}};
    expect_the_same_light(scene, 1e-11);
  }
}

/// A photon divides once a face and band: the first face gives each band its share, the second divides each band once.
/// Of many bands it follows sixteen.
TEST(PhotonWave, DividesOnceAFaceAndBand) {
  for (const int bands : {4, 64}) {
    const Scene scene = ball_of_bands(bands);
    const Intersector intersector(scene);
    const Targets targets = find_targets(scene, intersector);
    const PhotonPass pass{{scene, intersector}, {targets.surroundings.center}};
    const Chart sun = make_charts(scene, targets, 1000).front();
    const PhotonBlock block = trace_photons(pass, sun, stream_of(1, Purpose::kEmissionPosition), 0, 1000);
    EXPECT_EQ(block.divisions, 2000u * std::min(16u, static_cast<unsigned>(bands)));
    EXPECT_LT(block.ledger.closure(), 1e-12);
  }
}

}  // namespace
}  // namespace vitrail
