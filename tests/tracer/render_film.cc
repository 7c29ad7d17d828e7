/// The film: light is added to halves and layers, and unlit planes stay empty.

#include <gtest/gtest.h>

#include "render/pixel_sums.h"

namespace vitrail {
namespace {

TEST(Film, KeepsEachHalfAndTheMeanOfEachLayer) {
  Film film(4, 3);
  HalfPixel light;
  light[Layer::diffusion] = {1, 2, 4};
  light[Layer::refraction] = {8, 0, 0};
  film.add(0, 2, 1, light);
  film.add(1, 2, 1, Layer::diffusion, {3, 2, 0});
  EXPECT_EQ(film.half(0, 2, 1), (Rgb{9, 2, 4}));
  EXPECT_EQ(film.half(1, 2, 1), (Rgb{3, 2, 0}));
  EXPECT_EQ(film.radiance(2, 1), (Rgb{6, 2, 2}));
  EXPECT_EQ(film.layer(Layer::diffusion, 2, 1), (Rgb{2, 2, 2}));
  EXPECT_EQ(film.layer(Layer::refraction, 2, 1), (Rgb{4, 0, 0}));
  EXPECT_EQ(film.radiance(1, 2), (Rgb{}));
  EXPECT_EQ(film.layer_plane(Layer::diffusion, 1)[1 * 4 + 2], 2);
  EXPECT_EQ(film.half_plane(1, 0)[1 * 4 + 2], 3);
  EXPECT_TRUE(film.is_lit(Layer::refraction));
  EXPECT_FALSE(film.is_lit(Layer::caustic));
}

/// A million photons of one flux in one pixel: summed as floats they would stop growing.
TEST(PixelSums, AreAsExactAsDoubles) {
  Film film(1, 1);
  PixelSums sums(film);
  for (int i = 0; i < 1000000; ++i) sums.add(0, 0, {0.1, 1e-3, 1});
  sums.develop(film, 0, Layer::caustic);
  EXPECT_EQ(film.half(0, 0, 0), (Rgb{float(1e5), float(1e3), float(1e6)}));
}

}  // namespace
}  // namespace vitrail
