/// Area lamps seen on a card, against their form factors [Howell B-3, B-13].

#include <gtest/gtest.h>

#include "build_scene.h"
#include "render/render.h"

namespace vitrail {
namespace {

/// Irradiance that a lamp 2 m above brings to a card at x = `aside`, by the radiance of one pixel.
double irradiance_under(const AreaLight& lamp, double aside) {
  SceneBuilder builder;
  builder.add("card", RectangleShape{{0, 0, 0}, {5, 0, 0}, {0, 0, -5}}, builder.add(diffuse(1)));
  builder.scene.lights.push_back({"lamp", lamp});
  builder.scene.camera = {CameraKind::orthographic, {aside, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 1e-6, 1e-6};
  builder.scene.image = {1, 1};
  builder.scene.plan.caustic = false;
  builder.scene.settings.samples = 1024;
  SilentMonitor monitor;
  return kPi * render(builder.scene, {1, monitor}).film.radiance(0, 0).r;
}

/// 1024 stratified samples of a smooth integrand; half a percent is what is asked.
constexpr double kHalfAPercent = 0.005;

TEST(AreaLamp, OfARectangleIsItsFormFactor) {
  const AreaLight lamp{RectangleShape{{0, 2, 0}, {0.5, 0, 0}, {0, 0, 0.3}}, false, {1, 1, 1}, {}};
  EXPECT_NEAR(irradiance_under(lamp, 0) / 0.142003869604, 1, kHalfAPercent);
}

TEST(AreaLamp, OfADiscIsItsFormFactorOnAndOffTheAxis) {
  const AreaLight lamp{DiscShape{{0, 2, 0}, {0, -1, 0}, 0.5}, false, {1, 1, 1}, {}};
  EXPECT_NEAR(irradiance_under(lamp, 0) / 0.184799567858, 1, kHalfAPercent);
  const double square = 1 + 4, r = 0.5;
  const double aside = kPi / 2 * (1 - (square - r * r) / std::sqrt((square + r * r) * (square + r * r) - 4 * r * r));
  EXPECT_NEAR(irradiance_under(lamp, 1) / aside, 1, kHalfAPercent);
}

}  // namespace
}  // namespace vitrail
