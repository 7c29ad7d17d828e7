/// A sky from an image: which way is up, and draws in proportion to what it sends.

#include <gtest/gtest.h>

#include "build_scene.h"
#include "scene/sky_image.h"

namespace vitrail {
namespace {

/// 8 x 4 pixels, each with its own radiance: red counts columns, green rows.
SkyImage numbered_sky() {
  std::vector<Rgb> pixels;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 8; ++column) pixels.push_back({1.0 + column, 1.0 + row, 1});
  }
  return {8, 4, pixels};
}

TEST(SkyImage, HasTheAxesOfOpenExr) {
  const SkyImage sky = numbered_sky();
  EXPECT_EQ(sky.towards({0, 1, 0}).g, 1);   // up is the top row
  EXPECT_EQ(sky.towards({0, -1, 0}).g, 4);  // down the bottom one
  const double tiny = 1e-6;
  EXPECT_EQ(sky.towards(normalise({-tiny, 0.1, 1})).r, 5);  // right of the middle: just beyond +z towards -x
  EXPECT_EQ(sky.towards(normalise({tiny, 0.1, 1})).r, 4);
  EXPECT_EQ(sky.towards(normalise({1, 0.1, tiny})).r, 3);    // +x is a quarter to the left of the middle
  EXPECT_EQ(sky.towards(normalise({-1, 0.1, -tiny})).r, 7);  // -x a quarter to the right
  EXPECT_EQ(sky.towards(normalise({tiny, 0.1, -1})).r, 1);   // -z at both edges
  EXPECT_EQ(sky.towards(normalise({-tiny, 0.1, -1})).r, 8);
}

/// Draws find the radiance that is there; weighed by their density they integrate to the total.
TEST(SkyImage, DrawsWhatItSends) {
  const SkyImage sky = numbered_sky();
  TestNumbers numbers;
  Rgb sum;
  double upwards = 0;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const SkyImage::Draw draw = sky.draw(numbers.unit(), numbers.unit());
    ASSERT_NEAR(length(draw.direction), 1, 1e-12);
    ASSERT_EQ(sky.towards(draw.direction), draw.radiance);
    sum += draw.radiance * (1 / draw.density / kCount);
    upwards += 1 / draw.density / kCount;
  }
  // Solid angles of the rows: 2 pi (cos a - cos b) with cos 0, 45, 90, 135, 180 degrees.
  const double rows[] = {1 - std::sqrt(0.5), std::sqrt(0.5), std::sqrt(0.5), 1 - std::sqrt(0.5)};
  double green = 0;
  for (int row = 0; row < 4; ++row) green += 2 * kPi * rows[row] * (row + 1);
  EXPECT_NEAR(sky.total().g, green, 1e-12);
  EXPECT_NEAR(sky.total().r, 4 * kPi * 4.5, 1e-12);
  // Radiance over density varies by a factor of two: errors of about 0.3 / sqrt(1e5) of the value; four of these.
  EXPECT_NEAR(sum.g / sky.total().g, 1, 0.004);
  EXPECT_NEAR(sum.r / sky.total().r, 1, 0.004);
  EXPECT_NEAR(upwards / (4 * kPi), 1, 0.008);
}

TEST(SkyImage, OfBlackDrawsNothing) {
  const SkyImage sky(2, 1, {{}, {}});
  EXPECT_EQ(sky.draw(0.3, 0.4).density, 0);
  EXPECT_EQ(sky.total(), (Rgb{}));
}

}  // namespace
}  // namespace vitrail
