/// The white furnace around turned solids of glass: a torus and cups, which hide themselves.

#include <gtest/gtest.h>

#include <algorithm>

#include "build_furnace.h"

namespace vitrail {
namespace {

constexpr int kFine = 24;  // pixels a side
/// Noise of the weak branches that are left to chance: many in a cup, whose faces divide the light again and again.
constexpr double kNoise = 1e-4;

TEST(TurnedFurnace, HidesATorusAndALatheOfClearGlass) {
  const Shape shapes[] = {
      TorusShape{{0, 0, 0}, normalise({1, 2, 3}), 0.6, 0.3}, TorusShape{{0, 0, 0}, {0, 1, 0}, 0.8, 0.01},
      LatheShape{{{0, -0.8}, {0.6, -0.8}, {0.1, -0.6}, {0.7, 0.6}, {0.65, 0.6}, {0, -0.5}}, turned()},
      LatheShape{{{0.4, -0.5}, {0.7, -0.5}, {0.7, 0.5}, {0.4, 0.5}}, {}}};
  for (const Shape& shape : shapes) {
    for (const bool fresnel : {false, true}) {
      Scene scene = furnace({{0, 0, 1}, fresnel, NoRoughness{}, false});
      scene.objects[0].shape = shape;
      scene.image = {kFine, kFine};
      const Film film = rendered(scene);
      for (int y = 0; y < kFine; ++y) {
        for (int x = 0; x < kFine; ++x) {
          EXPECT_LE(film.radiance(x, y).r, 1 + kNoise) << shape.index() << " " << x << " " << y;
          EXPECT_GE(film.radiance(x, y).r, 1 - kNoise) << shape.index() << " " << x << " " << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace vitrail
