/// Means over the gather disc: near a straight edge of even light a disc holds a segment of a circle of it.

#include <gtest/gtest.h>

#include <algorithm>

#include "build_scene.h"
#include "render/render.h"

namespace vitrail {
namespace {

constexpr double kRadius = 0.25, kAlbedo = 0.5;
constexpr int kColumns = 16, kRows = 8;

Rendering rendered(const Scene& scene, unsigned threads = 1) {
  SilentMonitor monitor;
  return render(scene, {threads, monitor});
}

/// The share of a disc on one side of a line, u radii from its middle.
double share_beside_line(double u) {
  u = std::clamp(u, -1.0, 1.0);
  return 0.5 + (u * std::sqrt(1 - u * u) + std::asin(u)) / kPi;
}

/// A sun of irradiance 1 through a clear pane: its light on the floor ends at x = 0. Seen from above, `middle` in the
/// middle of the picture.
Scene lit_floor(Solver solver, double middle) {
  SceneBuilder builder;
  builder.add("floor", RectangleShape{{0, 0, 0}, {2, 0, 0}, {0, 0, -2}}, builder.add(diffuse(kAlbedo)));
  builder.add("pane", BoxShape{{-1, 1, -0.6}, {0, 1.1, 0.6}, {}}, builder.add(glass(1.5)));
  builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {1, 1, 1}, 0}});
  builder.scene.camera = {CameraKind::orthographic, {middle, 0.5, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 0.4, 0.2};
  builder.scene.image = {kColumns, kRows};
  builder.scene.settings.samples = solver == Solver::beams ? 512 : 16;
  builder.scene.settings.photons = 200000;
  builder.scene.settings.gather_radius_m = kRadius;
  builder.scene.settings.gather_disc = true;
  builder.scene.settings.solver = solver;
  return builder.scene;
}

/// The caustic in a column over that of even light without an edge.
double seen_in_column(const Film& film, int x) {
  double sum = 0;
  for (int y = 0; y < kRows; ++y) sum += film.layer(Layer::caustic, x, y).g;
  return sum / kRows / (kAlbedo / kPi);
}

/// The mean of a law of x over a column.
template <typename Law>
double mean_over_column(const Law& law, double middle, int x) {
  constexpr int kSteps = 64;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += law(middle - 0.4 + 0.8 * (x + (i + 0.5) / kSteps) / kColumns);
  return sum / kSteps;
}

/// Beams end within a cell of their lattice (4 mm) of the edge, which moves the share by 2 / (pi radius) of that, 1 %.
/// The noise of 4096 places in a column is below that, and so is that of 14 000 photons in a disc.
constexpr double kTolerance = 0.01;

class GatherDisc : public testing::TestWithParam<Solver> {};
INSTANTIATE_TEST_SUITE_P(Solvers, GatherDisc, testing::Values(Solver::photon_map, Solver::light_bins, Solver::beams),
                         [](const auto& one) { return name_of(one.param); });

TEST_P(GatherDisc, HoldsASegmentOfTheLightAtItsEdge) {
  const Film film = rendered(lit_floor(GetParam(), 0), 2).film;
  const auto law = [](double x) { return share_beside_line(-x / kRadius); };
  for (int x = 0; x < kColumns; ++x)
    EXPECT_NEAR(seen_in_column(film, x), mean_over_column(law, 0, x), kTolerance) << "column " << x;
}

/// Where the floor ends in the light, the disc passes its edge and counts with its whole area.
TEST_P(GatherDisc, CountsWholeWhereTheSurfaceEnds) {
  constexpr double kEnd = -0.5;
  Scene scene = lit_floor(GetParam(), kEnd);
  std::get<RectangleShape>(scene.objects[0].shape).center.x = kEnd - 2;
  const Film film = rendered(scene, 2).film;
  const auto law = [](double x) { return share_beside_line((kEnd - x) / kRadius); };
  // The last column before the end, and the first one that sees nothing.
  for (int x = 3; x < kColumns / 2; ++x)
    EXPECT_NEAR(seen_in_column(film, x), mean_over_column(law, kEnd, x), kTolerance) << "column " << x;
  for (int x = kColumns / 2; x < kColumns; ++x) EXPECT_EQ(seen_in_column(film, x), 0) << "column " << x;
}

/// Without it beams and bins show the edge as it is.
TEST(NoGatherDisc, LeavesTheEdgeSharp) {
  for (const Solver solver : {Solver::light_bins, Solver::beams}) {
    Scene scene = lit_floor(solver, 0);
    scene.settings.gather_disc = false;
    const Film film = rendered(scene, 2).film;
    EXPECT_NEAR(seen_in_column(film, kColumns / 2 - 2), 1, 0.05) << name_of(solver);
    EXPECT_EQ(seen_in_column(film, kColumns / 2 + 1), 0) << name_of(solver);
  }
}

/// One look or many, one thread or many, in the scene's picture or in a view.
TEST(GatherDiscOfBeams, IsTheSameForAnyNumberOfThreads) {
  Scene scene = lit_floor(Solver::beams, 0);
  scene.settings.samples = 1;
  scene.views = {scene.picture()};
  const Rendering one = rendered(scene, 1), seven = rendered(scene, 7);
  bool halves_differ = false;
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      EXPECT_EQ(one.film.radiance(x, y), seven.film.radiance(x, y));
      EXPECT_EQ(one.film.radiance(x, y), one.views[0].film.radiance(x, y));
      halves_differ = halves_differ || one.film.half(0, x, y) != one.film.half(1, x, y);
    }
  }
  EXPECT_TRUE(halves_differ);  // each half draws its own places
}

}  // namespace
}  // namespace vitrail
