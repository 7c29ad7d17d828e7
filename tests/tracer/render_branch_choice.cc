/// Looks that leave weak branches to chance, against piles of panes, and the ledger of what the limits cut.

#include <gtest/gtest.h>

#include <cmath>

#include "build_scene.h"
#include "material/branch_choice.h"
#include "render/render.h"

namespace vitrail {
namespace {

/// What each way counts for, averaged over evenly spread chance.
BranchFactors mean_factors(const CarriedShares& carried, double least) {
  constexpr int kDraws = 1 << 20;
  BranchFactors sum{};
  for (int i = 0; i < kDraws; ++i) {
    const BranchFactors one = choose_branches(carried, least, (i + 0.5) / kDraws);
    for (int way = 0; way < 2; ++way) sum[way] += one[way] / kDraws;
  }
  return sum;
}

/// Chance adds nothing and takes nothing: the mean factor of a way is 1, to the step of the draws.
TEST(BranchChoice, CountsEveryWayOnceInTheMean) {
  for (const CarriedShares carried : {CarriedShares{0.9, 0.002}, CarriedShares{0.002, 0.9}, CarriedShares{0.004, 0.003},
                                      CarriedShares{0.009, 0.008}, CarriedShares{1e-5, 0.0099}}) {
    const BranchFactors mean = mean_factors(carried, 0.01);
    for (int way = 0; way < 2; ++way) EXPECT_NEAR(mean[way], 1, 2e-3) << carried[0] << " " << carried[1];
  }
}

/// Two weak ways of one path that carries the least share have it together: one of them goes on, always.
TEST(BranchChoice, NeverEndsAPathOfTheLeastShareInClearGlass) {
  for (double chance : {1e-12, 0.3, 0.9599999, 0.9600001, 1 - 1e-12}) {
    const BranchFactors factors = choose_branches({0.96 * 0.01, 0.04 * 0.01}, 0.01, chance);
    EXPECT_NEAR(factors[0] * 0.0096 + factors[1] * 0.0004, 0.01, 1e-16) << chance;
    EXPECT_TRUE(factors[0] == 0 || factors[1] == 0) << chance;
  }
}

/// The mean of `share_out` is 1 as well, and its sum is that of the ways until a path has next to nothing.
TEST(BranchChoice, SharesOutWhatBothWaysCarry) {
  for (const CarriedShares carried :
       {CarriedShares{0.9, 0.002}, CarriedShares{0.002, 0.012}, CarriedShares{0.004, 0.003}, CarriedShares{0.015, 0},
        CarriedShares{0.0004, 0.0011}}) {
    constexpr int kDraws = 1 << 20;
    const double all = carried[0] + carried[1];
    BranchFactors mean{};
    for (int i = 0; i < kDraws; ++i) {
      const BranchFactors one = share_out(carried, 0.01, (i + 0.5) / kDraws);
      for (int way = 0; way < 2; ++way) mean[way] += one[way] / kDraws;
      if (all > 0.0025) {
        EXPECT_NEAR(one[0] * carried[0] + one[1] * carried[1], all, 1e-15);
      }
    }
    for (int way = 0; way < 2; ++way) {
      if (carried[way] > 0) {
        EXPECT_NEAR(mean[way], 1, 2e-3) << carried[0] << " " << carried[1];
      }
    }
  }
}

TEST(BranchChoice, FollowsBothWaysThatMatter) {
  EXPECT_FALSE(leaves_to_chance({0.5, 0.01}, 0.01));
  EXPECT_FALSE(leaves_to_chance({0.5, 0}, 0.01));
  EXPECT_FALSE(leaves_to_chance({1e-9, 1e-9}, 0));
  EXPECT_TRUE(leaves_to_chance({0.5, 0.0099}, 0.01));
}

constexpr double kReflectance = 0.04;  // of one face of index 1.5, at right angles

/// Stokes (1862): what N clear panes let through, with all reflections between and in them.
double let_through(int panes) { return (1 - kReflectance) / (1 + (2 * panes - 1) * kReflectance); }

/// A camera that looks straight down on panes over a glowing floor, under a dark or a glowing sky.
Scene pile(int panes, int limit, double sky) {
  SceneBuilder builder;
  Material floor = diffuse(0);
  floor.emission = Rgb{1, 1, 1};
  builder.add("floor", PlaneShape{{0, -4, 0}, {0, 1, 0}}, builder.add(floor));
  const auto clear = builder.add(glass(1.5, {1, 1, 1}, true));
  for (int i = 0; i < panes; ++i)
    builder.add("pane" + std::to_string(i), BoxShape{{-9, 0.02 * i, -9}, {9, 0.02 * i + 0.01, 9}, {}}, clear);
  if (sky > 0) builder.scene.lights.push_back({"sky", EnvironmentLight{Rgb{1, 1, 1} * sky, nullptr}});
  builder.scene.camera = {CameraKind::orthographic, {0, 3, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 0.5, 0.5};
  builder.scene.image = {16, 16};
  builder.scene.plan.caustic = false;
  builder.scene.transport.max_reflections = builder.scene.transport.max_transmissions = limit;
  return builder.scene;
}

Rendering rendered(const Scene& scene, unsigned threads = 2) {
  SilentMonitor monitor;
  return render(scene, {threads, monitor});
}

/// Mean of all pixels, and its standard error from how they scatter: they are independent.
struct Mean {
  double value = 0, error = 0;
};
Mean mean_of(const Film& film) {
  double sum = 0, squares = 0;
  const int count = film.width() * film.height();
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const double value = film.radiance(x, y).g;
      sum += value;
      squares += value * value;
    }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / count)};
}

/// Four standard errors: a seed in 16 000 is beyond.
constexpr double kErrors = 4;

/// A dispersive ball under an even sky, its weak branches left to chance: every pixel shows the sky. Limits that cut
/// nothing, and what floats round.
TEST(BranchChoice, HasNoNoiseInAFurnace) {
  SceneBuilder builder;
  builder.scene.bands.clear();
  Material flint = glass(1.7, {1, 1, 1}, true);
  flint.ior_by_band.clear();
  flint.ior_minus_one_by_band.clear();
  for (int band = 0; band < 6; ++band) {
    builder.scene.bands.push_back({"band", Rgb{1, 1, 1} * (1.0 / 6), {}});
    flint.ior_by_band.push_back(1.6 + 0.05 * band);
    flint.ior_minus_one_by_band.push_back(0.6 + 0.05 * band);
  }
  builder.add("ball", SphereShape{{0, 0, 0}, 1}, builder.add(flint));
  builder.scene.lights.push_back({"sky", EnvironmentLight{Rgb{1, 1, 1}, nullptr}});
  builder.scene.camera = {CameraKind::orthographic, {0, 3, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 1.1, 1.1};
  builder.scene.image = {24, 24};
  builder.scene.transport.max_reflections = builder.scene.transport.max_transmissions = 500;
  const Rendering result = rendered(builder.scene);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) EXPECT_NEAR(result.film.radiance(x, y).g, 1, 2 * kFilmRounding) << x << " " << y;
  EXPECT_EQ(result.camera_ledger.cut(), 0);
}

TEST(PileOfPanes, LetsThroughWhatStokesSays) {
  for (int panes : {1, 2, 4, 6, 20, 40}) {
    for (std::uint64_t seed : {1, 2, 3}) {
      Scene scene = pile(panes, 1000, 0);
      scene.settings.seed = seed;
      const Rendering result = rendered(scene);
      const Mean found = mean_of(result.film);
      EXPECT_NEAR(found.value, let_through(panes), kErrors * found.error + kFilmRounding)
          << panes << " panes, seed " << seed;
      EXPECT_LT(found.error, 0.01) << panes;
      EXPECT_TRUE(result.warnings.empty()) << panes;
    }
  }
}

TEST(PileOfPanes, IsWhiteInAFurnace) {
  for (int panes : {1, 4, 20}) {
    const Mean found = mean_of(rendered(pile(panes, 1000, 1)).film);
    EXPECT_NEAR(found.value, 1, kErrors * found.error + kFilmRounding) << panes;
  }
}

TEST(PileOfPanes, CostsAHundredRaysALookThroughSixPanes) {
  for (int panes : {4, 6}) {
    Scene scene = pile(panes, 1000, 0);
    scene.settings.samples = 16;
    const double looks = 16.0 * 16 * 16;
    EXPECT_LE(static_cast<double>(rendered(scene).counters.camera_rays) / looks, 110) << panes;
  }
}

/// Without chance there is no noise, and both halves are one picture.
TEST(PileOfPanes, HasNoNoiseWhereEverythingIsFollowed) {
  Scene scene = pile(1, 20, 0);
  scene.settings.branch_share = 0;
  const Rendering result = rendered(scene);
  for (int half : {0, 1}) EXPECT_NEAR(result.film.half(half, 3, 5).g, let_through(1), kFilmRounding) << half;
}

/// What chance does in one half says nothing about the other: their difference is the noise of the mean.
TEST(PileOfPanes, HasIndependentHalves) {
  for (int samples : {1, 4}) {
    Scene scene = pile(6, 1000, 0);
    scene.image = {64, 64};
    scene.settings.samples = samples;
    const Film film = rendered(scene).film;
    double product = 0, squares = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const double a = film.half(0, x, y).g - let_through(6), b = film.half(1, x, y).g - let_through(6);
        product += a * b;
        squares += 0.5 * (a * a + b * b);
      }
    }
    EXPECT_GT(squares, 0);
    EXPECT_LT(std::abs(product / squares), kErrors / 64) << samples;
  }
}

TEST(PileOfPanes, KeepsItsBitsForAnyThreads) {
  const Scene scene = pile(6, 1000, 0);
  const Film one = rendered(scene, 1).film, three = rendered(scene, 3).film;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) EXPECT_EQ(one.radiance(x, y).g, three.radiance(x, y).g);
}

/// In a furnace the look shows all that the limits did not cut: the ledger closes.
TEST(CameraLedger, HasWhatIsMissingInAFurnace) {
  for (int panes : {20, 40}) {
    for (int limit : {8, 64}) {
      const Rendering result = rendered(pile(panes, limit, 1));
      const Mean found = mean_of(result.film);
      EXPECT_NEAR(found.value + result.camera_ledger.cut(), 1, kErrors * found.error) << panes << " " << limit;
      EXPECT_GT(result.camera_ledger.cut(), 0.005) << panes << " " << limit;
    }
  }
}

/// Forty panes have eighty faces: at the usual limits nothing is seen through them, and the tracer says so.
TEST(CameraLedger, WarnsOfWhatTheLimitsCutWithItsPlace) {
  Scene scene = pile(40, 64, 0);
  scene.transport.max_reflections = 8;
  const Rendering result = rendered(scene);
  ASSERT_EQ(result.warnings.size(), 1u);
  for (const char* words : {"cut after 64 transmissions", "`pane", "raise transport.max_transmissions", "x 0 to 15"})
    EXPECT_NE(result.warnings[0].find(words), std::string::npos) << result.warnings[0];
  EXPECT_GT(result.camera_ledger.cut(Limit::max_transmissions), result.camera_ledger.cut(Limit::max_reflections));
  EXPECT_GT(result.camera_ledger.cut(Layer::refraction), 0);
  EXPECT_EQ(result.camera_ledger.cut(Layer::diffusion), 0);
}

/// In one pane light goes to and fro, and each turn leaves the share R of it. The first branch below 1e-3 and 1e-4 is
/// that after three turns; one turn more is below 1e-5, and one more below 1e-6.
TEST(CameraLedger, BooksWhatARendererWouldLoseThatDropsWeakBranches) {
  Scene scene = pile(1, 1000, 1);
  for (double branch_share : {0.0, 0.01}) {
    scene.settings.branch_share = branch_share;
    scene.settings.samples = branch_share > 0 ? 64 : 1;
    const Rendering result = rendered(scene);
    const double within = branch_share > 0 ? 0.1 : 1e-12;  // chance follows the third turn in one of seven looks
    for (const auto& [place, turns] : {std::pair{0, 3}, {1, 3}, {2, 4}, {3, 5}}) {
      const double right = (1 - kReflectance) * std::pow(kReflectance, turns);
      EXPECT_NEAR(result.camera_ledger.weak(place) / right, 1, place < 2 || branch_share == 0 ? within : 1) << place;
    }
    EXPECT_EQ(result.camera_ledger.cut(), 0);
  }
}

TEST(CameraLedger, IsEmptyWhereNothingIsCut) {
  const Rendering result = rendered(pile(1, 1000, 0));
  EXPECT_EQ(result.camera_ledger.cut(), 0);
  EXPECT_TRUE(result.warnings.empty());
}

}  // namespace
}  // namespace vitrail
