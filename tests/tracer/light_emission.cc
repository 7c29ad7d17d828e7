/// Photons and shadow rays are two views of one light: what flies through a patch is what `illuminate` says arrives.

#include <gtest/gtest.h>

#include "base/random.h"
#include "build_scene.h"
#include "light/light.h"

namespace vitrail {
namespace {

constexpr std::uint32_t kCount = 1 << 16;
constexpr double kPatchRadius = 0.2;

/// A sphere of radius 0.5 to aim at, with a patch through its centre that faces +y.
Targets one_target() {
  const BoundingSphere bound{{0.3, 0.1, -0.2}, 0.5};
  const Vec3 reach{0.5, 0.5, 0.5};
  return {{{0, bound, {bound.center - reach, bound.center + reach}}}, {{bound.center, 3}, {}}, {}};
}

/// Power of a chart's photons that cross the patch from above, W.
double photon_flux(const Chart& chart, Vec3 center) {
  double flux = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto u = sobol_4d(stream_of(1, Purpose::kEmissionPosition), i);
    const Emission photon = emit(chart, {unit_point(u[0], u[1]), unit_point(u[2], u[3])});
    EXPECT_NEAR(length(photon.ray.direction), 1, 1e-15);
    if (!(photon.ray.direction.y < 0)) continue;
    const double t = (center.y - photon.ray.origin.y) / photon.ray.direction.y;
    if (t > 0 && length(photon.ray.at(t) - center) < kPatchRadius) flux += photon.power.r / kCount;
  }
  return flux;
}

/// The same from the other side: irradiance times area, averaged over the patch and the light.
double illuminated_flux(const Light& light, Vec3 center) {
  double sum = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto u = sobol_4d(stream_of(2, Purpose::kLightSample), i);
    const double r = kPatchRadius * std::sqrt(u[0]), a = 2 * kPi * u[1];
    const Vec3 at = center + Vec3{r * std::cos(a), 0, r * std::sin(a)};
    const Illumination from = illuminate(light, at, {0, 1, 0}, unit_point(u[2], u[3]));
    sum += from.irradiance.r * std::max(0.0, from.toward.y);
  }
  return sum / kCount * kPi * kPatchRadius * kPatchRadius;
}

void expect_two_equal_views(const Emitter& emitter) {
  Scene scene;
  scene.lights.push_back({"light", emitter});
  const Targets targets = one_target();
  const std::vector<Chart> charts = make_charts(scene, targets, kCount);
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].count, kCount);
  const Vec3 center = targets.targets[0].bound.center;
  const double photons = photon_flux(charts[0], center), shadow_rays = illuminated_flux(scene.lights[0], center);
  EXPECT_GT(shadow_rays, 0);
  // The patch takes at least 2 % of the photons: 1300 counts, a stratified error below 1 / sqrt(1300) / 3.
  EXPECT_NEAR(photons / shadow_rays, 1, 0.01);
}

TEST(Emission, OfParallelLightIsItsIrradiance) {
  expect_two_equal_views(DirectionalLight{normalise({0.3, -1, 0.2}), {2, 2, 2}, 0});
}
TEST(Emission, OfASunIsItsIrradiance) {
  expect_two_equal_views(DirectionalLight{normalise({0.3, -1, 0.2}), {2, 2, 2}, 30});
}
TEST(Emission, OfAPointIsItsIrradiance) { expect_two_equal_views(PointLight{{1, 2, 0}, {5, 5, 5}}); }
TEST(Emission, OfAPointInsideTheSphereIsItsIrradiance) {
  expect_two_equal_views(PointLight{{0.3, 0.3, -0.1}, {5, 5, 5}});
}
TEST(Emission, OfAWideSpotIsItsIrradiance) {
  expect_two_equal_views(SpotLight{{0.3, 2, -0.2}, {0, -1, 0}, {5, 5, 5}, 60});
}
TEST(Emission, OfANarrowSpotIsItsIrradiance) {
  expect_two_equal_views(SpotLight{{0.2, 2, -0.2}, normalise({0, -1, 0.05}), {5, 5, 5}, 10});
}
TEST(Emission, OfALampIsItsIrradiance) {
  expect_two_equal_views(AreaLight{RectangleShape{{0, 2, 0}, {0.5, 0, 0}, {0, 0, 0.7}}, false, {3, 3, 3}, {}});
  expect_two_equal_views(AreaLight{DiscShape{{1, 1.5, 0}, normalise({-0.5, -1, 0}), 0.6}, false, {3, 3, 3}, {}});
}
TEST(Emission, OfACollimatedLampIsItsIrradiance) {
  expect_two_equal_views(AreaLight{RectangleShape{{0.2, 2, 0}, {0.5, 0, 0}, {0, 0, 0.4}}, true, {}, {3, 3, 3}});
}
TEST(Emission, OfAnEnvironmentIsItsIrradiance) { expect_two_equal_views(EnvironmentLight{{1, 1, 1}, nullptr}); }

TEST(Emission, OfASkyImageIsItsIrradiance) {
  // One bright pixel high up, others dim.
  std::vector<Rgb> pixels(16 * 8, Rgb{0.1, 0.1, 0.1});
  pixels[16 * 1 + 5] = {20, 20, 20};
  expect_two_equal_views(EnvironmentLight{{}, std::make_shared<const SkyImage>(16, 8, pixels)});
}

/// A Lambertian disc seen on its axis: E = pi L r^2 / (r^2 + h^2).
TEST(Illumination, OfADiscOnItsAxisIsTheFormFactor) {
  const Light lamp{"lamp", AreaLight{DiscShape{{0, 2, 0}, {0, -1, 0}, 0.6}, false, {3, 3, 3}, {}}};
  double sum = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto u = sobol_2d(stream_of(4, Purpose::kLightSample), i);
    const Illumination from = illuminate(lamp, {0, 0, 0}, {0, 1, 0}, unit_point(u[0], u[1]));
    sum += from.irradiance.r * from.toward.y;
  }
  EXPECT_NEAR(sum / kCount, kPi * 3 * 0.36 / (0.36 + 4), 1e-5);
}

/// Photons shared out among two targets follow their power, and every chart gets at least one.
/// A lamp much wider than it is far: a disc of radius R at height h brings pi L R^2 / (R^2 + h^2) to a card on its axis
/// that faces it, and few points say so. The largest answer to one point is 2 pi L, so that no pixel is a spark.
TEST(Illumination, OfAWideLampNearByIsItsFormFactor) {
  for (const double radius : {1.5, 30.0, 3000.0}) {
    const Light lamp{"lamp", AreaLight{DiscShape{{0, 1, 0}, {0, -1, 0}, radius}, false, {1, 1, 1}, {}}};
    const double truth = kPi * radius * radius / (radius * radius + 1);
    double sum = 0;
    for (std::uint32_t i = 0; i < 64; ++i) {
      const auto u = sobol_2d(Stream{5}, i);
      const Illumination from = illuminate(lamp, {0, 0, 0}, {0, 1, 0}, unit_point(u[0], u[1]));
      const double one = from.irradiance.g * from.toward.y;
      EXPECT_LE(one, 2 * kPi);
      sum += one / 64;
    }
    EXPECT_NEAR(sum / truth, 1, 0.02) << radius;  // 64 points of a net for a smooth integrand
  }
}

/// The same of a rectangle above a place beside its middle: 4 corners of arctangents (Wong 1949 for a quarter).
TEST(Illumination, OfAWideRectangleNearByIsItsFormFactor) {
  const Light lamp{"lamp", AreaLight{RectangleShape{{2, 1, 0}, {8, 0, 0}, {0, 0, 5}}, false, {1, 1, 1}, {}}};
  const auto corner = [](double a, double b) {
    const double p = std::hypot(1, a), q = std::hypot(1, b);
    return 0.5 * (a / p * std::atan(b / p) + b / q * std::atan(a / q));
  };
  const double truth = 2 * (corner(10, 5) + corner(6, 5));
  double sum = 0;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    const auto u = sobol_2d(Stream{5}, i);
    const Illumination from = illuminate(lamp, {0, 0, 0}, {0, 1, 0}, unit_point(u[0], u[1]));
    sum += from.irradiance.g * std::abs(from.toward.y) / 4096;
  }
  EXPECT_NEAR(sum / truth, 1, 5e-3);
}

TEST(Charts, ShareOutPhotonsByPower) {
  Scene scene;
  scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {1, 1, 1}, 0}});
  Targets targets = one_target();
  Target small = targets.targets[0];
  small.object = 1;
  small.bound.radius *= 0.5;
  small.box = {small.bound.center - Vec3{1, 1, 1}, small.bound.center + Vec3{1, 1, 1}};
  targets.targets.push_back(small);
  const auto charts = make_charts(scene, targets, 1000);
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].count, 800u);
  EXPECT_EQ(charts[1].count, 200u);
}

/// A collimated rectangle sends photons from where its light may meet the target, all of it and little else.
TEST(Emission, OfACollimatedRectangleIsAimed) {
  const Targets targets = one_target();
  const BoundingSphere& bound = targets.targets[0].bound;
  Scene scene;
  const auto charts_of_lamp_at = [&](Vec3 center) {
    scene.lights = {{"lamp", AreaLight{RectangleShape{center, {4, 0, 0}, {0, 0, -4}}, true, {}, {2, 2, 2}}}};
    return make_charts(scene, targets, kCount);
  };
  const std::vector<Chart> charts = charts_of_lamp_at({1, 5, 1});
  ASSERT_EQ(charts.size(), 1u);
  // The square around the sphere is 1 m wide, and E = 2 W/m2 falls on it.
  EXPECT_NEAR(charts[0].power.r, 2, 1e-7);
  std::uint32_t met = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto u = sobol_2d(stream_of(1, Purpose::kEmissionPosition), i);
    const Emission photon = emit(charts[0], {unit_point(u[0], u[1]), {}});
    const Vec3 offset = photon.ray.origin - bound.center;
    met += std::hypot(offset.x, offset.z) < bound.radius ? 1 : 0;
  }
  EXPECT_NEAR(met / static_cast<double>(kCount), kPi / 4, 1e-3);

  // Half of the target outside the lamp's beam, and all of it.
  EXPECT_NEAR(charts_of_lamp_at({4.3, 5, -0.2})[0].power.r, 1, 1e-7);
  EXPECT_TRUE(charts_of_lamp_at({9, 5, 9}).empty());
}

}  // namespace
}  // namespace vitrail
