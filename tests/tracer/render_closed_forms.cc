/// Whole renderings against closed forms: grey cards, slabs, the ball lens.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "render/render.h"

namespace vitrail {
namespace {

/// An orthographic camera that looks down on a square of half side `half` from height `y`.
Camera looking_down(double y, double half) {
  return {CameraKind::orthographic, {0, y, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, half, half};
}

Rendering rendered(const Scene& scene, unsigned threads = 1) {
  SilentMonitor monitor;
  return render(scene, {threads, monitor});
}

SceneBuilder card_scene(double albedo, double tilt_deg) {
  SceneBuilder builder;
  const Frame turn = turned_about_z(tilt_deg);
  const RectangleShape card{{0, 0, 0}, turn.direction_to_world({5, 0, 0}), {0, 0, -5}};
  builder.add("card", card, builder.add(diffuse(albedo)));
  builder.scene.camera = looking_down(10, 1);
  builder.scene.image = {5, 5};
  builder.scene.plan.caustic = false;
  return builder;
}

/// L = d E cos / pi, for several albedos, tilts and channels; the centre pixel of the image is the centre of the card.
TEST(GreyCard, UnderADirectionalLight) {
  for (double albedo : {0.18, 0.5, 1.0}) {
    for (double tilt : {0.0, 10.0, 45.0, 80.0, -60.0}) {
      SceneBuilder builder = card_scene(albedo, tilt);
      builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {1, 2, 3}, 0}});
      const Rgb found = rendered(builder.scene).film.radiance(2, 2);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[c], albedo * (c + 1) * std::cos(radians(tilt)) / kPi, kFilmRounding) << albedo << " " << tilt;
      }
    }
  }
}

TEST(GreyCard, UnderAPointLight) {
  for (double tilt : {0.0, 30.0, 70.0}) {
    SceneBuilder builder = card_scene(0.5, tilt);
    builder.scene.lights.push_back({"lamp", PointLight{{0, 2, 0}, {4, 8, 16}}});
    const Rgb found = rendered(builder.scene).film.radiance(2, 2);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(found[c], 0.5 * (1 << c) * std::cos(radians(tilt)) / kPi, kFilmRounding);
    }
  }
}

/// With its lamp under water the card loses light on the way from the lamp and on that to the camera, both inside:
/// L = d I / (pi h^2) exp(-a (h + y)), with or without shadow rays.
TEST(GreyCard, UnderWaterWithItsLampLosesLightOnBothWays) {
  for (bool shadow : {true, false}) {
    SceneBuilder builder = card_scene(0.5, 0);
    Material water = glass(1.33);
    water.absorption_per_m = {0, 0.1, 0.5};
    builder.add("water", BoxShape{{-9, -1, -9}, {9, 12, 9}, {}}, builder.add(water));
    builder.scene.lights.push_back({"lamp", PointLight{{0, 2, 0}, {4, 4, 4}}});
    builder.scene.plan.shadow = shadow;
    const Rgb found = rendered(builder.scene).film.radiance(2, 2);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], 0.5 / kPi * std::exp(-water.absorption_per_m[c] * (2 + 10)), kFilmRounding) << c << shadow;
  }
}

/// Off the centre: I cos / r^2 with r = h / cos.
TEST(GreyCard, UnderAPointLightFallsWithTheCubeOfTheCosine) {
  SceneBuilder builder = card_scene(0.5, 0);
  builder.scene.lights.push_back({"lamp", PointLight{{0, 2, 0}, {4, 4, 4}}});
  const Rgb found = rendered(builder.scene).film.radiance(4, 2);
  const double cosine = 2 / std::hypot(2, 0.8);
  EXPECT_NEAR(found.r, 0.5 / kPi * std::pow(cosine, 3), kFilmRounding);
}

/// Light on the far side of the card, and a card in the shadow of another, stay black.
TEST(GreyCard, IsBlackBehindAndInShadow) {
  SceneBuilder builder = card_scene(0.5, 0);
  builder.scene.lights.push_back({"below", PointLight{{0, -2, 0}, {4, 4, 4}}});
  EXPECT_EQ(rendered(builder.scene).film.radiance(2, 2), (Rgb{}));
  builder.scene.lights.push_back({"above", PointLight{{3, 3, 0}, {4, 4, 4}}});
  EXPECT_GT(rendered(builder.scene).film.radiance(2, 2).r, 0);
  builder.add("blind", DiscShape{{1.5, 1.5, 0}, {0, 1, 0}, 0.3}, 0);
  EXPECT_EQ(rendered(builder.scene).film.radiance(2, 2), (Rgb{}));
}

/// Under a sky of radiance 1 a card shows its albedo, with and without an index-1 ball in the way, and the sky
/// itself 1.
TEST(Environment, LightsACardWithPi) {
  SceneBuilder builder = card_scene(0.5, 0);
  builder.scene.lights.push_back({"sky", EnvironmentLight{{1, 1, 1}, nullptr}});
  builder.scene.settings.samples = 64;
  const Rgb found = rendered(builder.scene).film.radiance(2, 2);
  EXPECT_NEAR(found.r, 0.5, kFilmRounding);  // cosine-distributed samples of a constant: no noise
  builder.scene.objects.clear();
  EXPECT_NEAR(rendered(builder.scene).film.radiance(2, 2).r, 1, kFilmRounding);
}

/// The penumbra of a sun: at the edge of a half-plane shadow the sun is half hidden.
TEST(Sun, IsHalfHiddenOnTheEdgeOfTheShadow) {
  SceneBuilder builder = card_scene(1, 0);
  builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {kPi, kPi, kPi}, 10}});
  builder.scene.settings.samples = 4096;
  EXPECT_NEAR(rendered(builder.scene).film.radiance(2, 2).r, 1, 2e-3);  // 1 less the cosine's mean over 5 degrees
  builder.scene.camera = looking_down(0.5, 1e-6);
  builder.add("blind", RectangleShape{{5, 1, 0}, {5, 0, 0}, {0, 0, -5}}, 0);
  EXPECT_NEAR(rendered(builder.scene).film.radiance(2, 2).r, 0.5, 0.01);
}

/// What a glowing card behind a slab shows: all bounces, T = (1-R)/(1+R) [O 1.1 row 3]; 0.923077 at 0, 0.8362 at 60
/// deg.
double seen_through_slab(const Material& material, double tilt_deg, Layer* only = nullptr) {
  SceneBuilder builder;
  Material glow = diffuse(0);
  glow.emission = Rgb{1, 1, 1};
  builder.add("glow", RectangleShape{{0, -50, 0}, {20, 0, 0}, {0, 0, -20}}, builder.add(glow));
  builder.add("slab", BoxShape{{-50, -0.5, -50}, {50, 0.5, 50}, turned_about_z(tilt_deg)}, builder.add(material));
  builder.scene.camera = looking_down(100, 0.1);
  builder.scene.image = {1, 1};
  builder.scene.plan.caustic = false;
  builder.scene.transport.max_reflections = 40;
  builder.scene.settings.branch_share = 0;
  const Rendering result = rendered(builder.scene);
  return only == nullptr ? result.film.radiance(0, 0).r : result.film.layer(*only, 0, 0).r;
}

TEST(Slab, WithFresnelShowsAllBounces) {
  EXPECT_NEAR(seen_through_slab(glass(1.5, {1, 1, 1}, true), 0), 12.0 / 13, kFilmRounding);
  EXPECT_NEAR(seen_through_slab(glass(1.5, {1, 1, 1}, true), 60), 0.836233, 1e-6);
}

/// A glowing card behind a rod of glass, seen at a slant through its front: unfolded, the way of tan r = 1/2
/// through 39.7 widths crosses 20 walls, and each is a total reflection.
TEST(Rod, ShowsItsEndThroughTotalReflectionsThatCountAsCrossings) {
  SceneBuilder builder;
  Material glow = diffuse(0);
  glow.emission = Rgb{1, 1, 1};
  builder.add("glow", RectangleShape{{0, -41, 0}, {90, 0, 0}, {0, 0, -90}}, builder.add(glow));
  builder.add("rod", BoxShape{{-0.5, -39.7, -0.5}, {0.5, 0, 0.5}, {}}, builder.add(glass(1.5)));
  const double sine = 1.5 / std::sqrt(5.0), cosine = std::sqrt(1 - sine * sine);
  const Vec3 way{sine, -cosine, 0};
  builder.scene.camera = {CameraKind::orthographic, way * -2.0, way, {0, 0, 1}, {cosine, sine, 0}, 1e-6, 1e-6};
  builder.scene.image = {1, 1};
  builder.scene.plan.caustic = false;
  builder.scene.transport.max_reflections = 0;
  for (const auto& [crossings, seen] : {std::pair{22, 1.0}, std::pair{21, 0.0}}) {
    builder.scene.transport.max_transmissions = crossings;
    const Film film = rendered(builder.scene).film;
    EXPECT_EQ(film.radiance(0, 0).r, seen) << crossings;
    EXPECT_EQ(film.layer(Layer::total_internal_reflection, 0, 0).r, seen) << crossings;
  }
}

TEST(Slab, WithoutFresnelIsClear) { EXPECT_EQ(seen_through_slab(glass(1.5), 30), 1); }

TEST(Slab, WithATintShowsItsSquare) {
  for (double t : {0.9, 0.5, 0.1}) EXPECT_NEAR(seen_through_slab(glass(1.5, {t, t, t}), 20), t * t, kFilmRounding);
}

TEST(Slab, BelongsToRefraction) {
  Layer refraction = Layer::refraction;
  EXPECT_EQ(seen_through_slab(glass(1.5), 30, &refraction), 1);
}

/// A camera inside glass sees the world outside undimmed by the index: radiance over n squared is kept [O 1.1 row 10].
TEST(Slab, HoldsTheCamera) {
  SceneBuilder builder;
  Material glow = diffuse(0);
  glow.emission = Rgb{1, 1, 1};
  builder.add("glow", PlaneShape{{0, -3, 0}, {0, 1, 0}}, builder.add(glow));
  builder.add("slab", BoxShape{{-50, -1, -50}, {50, 1, 50}, {}}, builder.add(glass(1.5)));
  builder.scene.camera = looking_down(0, 0.1);
  builder.scene.plan.caustic = false;
  EXPECT_NEAR(rendered(builder.scene).film.radiance(0, 0).r, 1.5 * 1.5, kFilmRounding);
}

/// Annulus means of the ball lens: gain over the light without the ball, from the density of the ray map [O 1.6].
void expect_annuli(const Film& film, double metres_per_pixel, double tolerance = 0.01) {
  const double edges[] = {0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8};
  const double gain[] = {8.504, 7.014, 4.407, 2.433, 1.440, 0.7454, 0.3593};
  double sum[7] = {}, count[7] = {};
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const double rho = metres_per_pixel * std::hypot(x + 0.5 - film.width() / 2.0, y + 0.5 - film.height() / 2.0);
      for (int k = 0; k < 7; ++k) {
        if (rho < edges[k] || rho >= edges[k + 1]) continue;
        sum[k] += film.layer(Layer::caustic, x, y).r;
        ++count[k];
      }
    }
  }
  for (int k = 0; k < 7; ++k) EXPECT_NEAR(sum[k] / count[k] / (0.8 * gain[k]), 1, tolerance) << "annulus " << k;
}

Scene ball_lens() {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, 0, 0}, {0, 1, 0}}, builder.add(diffuse(0.8)));
  builder.add("ball", SphereShape{{0, 2, 0}, 1}, builder.add(glass(1.5)));
  builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {kPi, kPi, kPi}, 0}});
  builder.scene.camera = looking_down(0.5, 0.85);
  builder.scene.image = {170, 170};  // pixels of 1 cm
  builder.scene.settings.photons = 1000000;
  builder.scene.settings.solver = Solver::photon_map;
  builder.scene.settings.gather_radius_m = 0.015;
  return builder.scene;
}

TEST(BallLens, HasTheAnnuliOfItsRayMap) {
  const Rendering result = rendered(ball_lens(), 2);
  expect_annuli(result.film, 0.01);

  // In the shadow of the ball there is nothing but the caustic.
  EXPECT_EQ(result.film.layer(Layer::diffusion, 85, 85), (Rgb{}));
  EXPECT_LT(result.ledger.closure(), 1e-9);
}

TEST(BallLens, HasTheSameAnnuliInLightBins) {
  Scene scene = ball_lens();
  scene.settings.solver = Solver::light_bins;
  expect_annuli(rendered(scene, 2).film, 0.01);

  // The same seen in perspective from the same height: a half angle of 45 degrees shows twice as much.
  scene.camera = {CameraKind::perspective, {0, 0.5, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 1.7, 1.7};
  expect_annuli(rendered(scene, 2).film, 0.01);
}

/// A tenth of the rays, and of what is left 0.3 % are whole pixels that stand for the edges of the rings.
TEST(BallLens, HasTheSameAnnuliInBeams) {
  Scene scene = ball_lens();
  scene.settings.solver = Solver::beams;
  scene.settings.photons = 100000;
  const Rendering result = rendered(scene, 2);
  expect_annuli(result.film, 0.01, 0.004);
  EXPECT_LT(result.ledger.closure(), 1e-9);
  EXPECT_TRUE(result.warnings.empty());

  // The same seen in perspective: a half angle of 45 degrees shows twice as much.
  scene.camera = {CameraKind::perspective, {0, 0.5, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 1.7, 1.7};
  expect_annuli(rendered(scene, 2).film, 0.01, 0.004);
}

TEST(Limits, ThatCutLightAreTold) {
  Scene scene = ball_lens();
  scene.materials[1].fresnel = true;
  scene.settings.photons = 20000;
  EXPECT_TRUE(rendered(scene).warnings.empty()) << "eight mirrorings leave less than 1e-8";
  scene.transport.max_reflections = 0;
  const std::vector<std::string> warnings = rendered(scene).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("% of the photons' light was cut after 0 reflections"), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace vitrail
