/// Photons that leave weak branches to chance: nothing is lost or added in the mean, and piles of panes end.

#include "photon/photon_branches.h"

#include <gtest/gtest.h>

#include <cmath>

#include "build_scene.h"
#include "photon/trace.h"

namespace vitrail {
namespace {

/// Every factor is 1 in the mean over photons, to what 2^16 points of a scrambled net leave: weak ways, faint ways,
/// both, deep in a path.
TEST(PhotonBranches, CountEveryWayOnceInTheMean) {
  const PhotonBranches branches(Stream{7});
  constexpr std::uint32_t kPhotons = 1 << 16;
  const auto grey = [](double flux) { return Rgb{flux, flux, flux}; };
  for (const double share : {1.0, 0.04, 0.01}) {
    for (const double least : {1e-4, 0.02, 0.5}) {
      for (const int faces : {0, 3, 40}) {
        const DividedFlux flux{grey(0.04), grey(0.96)};
        BranchFactors sum{};
        for (std::uint32_t i = 0; i < kPhotons; ++i) {
          const WaysOn ways = branches.choose({share, least, i, {faces, 0}}, flux);
          for (int way = 0; way < 2; ++way) sum[way] += ways.factor[way] / kPhotons;
        }
        // A way is taken by at least one photon in 400 and then counts as much: 65536 points are even to a step or two.
        for (int way = 0; way < 2; ++way) EXPECT_NEAR(sum[way], 1, 0.03) << share << " " << least << " " << faces;
      }
    }
  }
}

TEST(PhotonBranches, FollowFirstReflectionsOfGlassAlways) {
  const PhotonBranches branches(Stream{7});
  const WaysOn ways = branches.choose({1, 1e-4, 3, {}}, {Rgb{0.04, 0.04, 0.04}, Rgb{0.96, 0.96, 0.96}});
  for (int way = 0; way < 2; ++way) EXPECT_EQ(ways.factor[way], 1);
  EXPECT_EQ(ways.share[0], 0.04);
}

/// Panes one behind the other under a lamp that looks straight at them, and a floor.
PhotonBlock through(int panes, std::uint64_t photons, double branch_share, Strategy strategy) {
  SceneBuilder builder;
  builder.add("floor", PlaneShape{{0, -2, 0}, {0, 1, 0}}, builder.add(diffuse(0.5)));
  const auto clear = builder.add(glass(1.5, {1, 1, 1}, true));
  for (int k = 0; k < panes; ++k) builder.add("pane", BoxShape{{-9, 0.02 * k, -9}, {9, 0.02 * k + 0.01, 9}, {}}, clear);
  builder.scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, {1, 1, 1}, 0}});
  builder.scene.transport.max_reflections = builder.scene.transport.max_transmissions = 1000;
  builder.scene.settings.branch_share = branch_share;
  const Intersector intersector(builder.scene);
  const Targets targets = find_targets(builder.scene, intersector);
  const PhotonPass pass{{builder.scene, intersector}, {targets.surroundings.center}};
  // The chart of the uppermost pane, which every photon meets first.
  const Chart chart = make_charts(builder.scene, targets, photons * static_cast<std::uint64_t>(panes)).back();
  return trace_photons(pass, chart, stream_of(3, Purpose::kEmissionPosition), 0, chart.count, strategy);
}

/// Stokes (1862): N panes let (1-R)/(1+(2N-1)R) through. The tree of twelve panes without chance has 10^5 branches.
TEST(PhotonBranches, PassPanesAsStokesSays) {
  constexpr double kReflectance = 0.04;
  for (const Strategy strategy : {Strategy::automatic, Strategy::tree}) {
    for (const int panes : {3, 12}) {
      const double truth = (1 - kReflectance) / (1 + (2 * panes - 1) * kReflectance);
      const double area = 18 * 18;
      const Ledger ledger = through(panes, 20000, 0.01, strategy).ledger;
      // A photon carries at most its flux through panes: the standard error is below sqrt(t (1 - t) / N).
      const double error = std::sqrt(truth * (1 - truth) / 20000);
      EXPECT_NEAR(ledger.stored.r / area, truth, 4 * error) << panes;
      EXPECT_NEAR((ledger.stored.r + ledger.escaped.r) / area, 1, 4 * error) << panes;
      EXPECT_LT(ledger.closure(), 1e-9);
    }
  }
}

/// What photons cost: five panes have hundreds of branches, of which some twenty matter.
TEST(PhotonBranches, AreFewInPanes) {
  const PhotonBlock all = through(5, 100, 0, Strategy::automatic), some = through(5, 100, 0.01, Strategy::automatic);
  EXPECT_LT(static_cast<double>(some.divisions), 0.1 * static_cast<double>(all.divisions));
}

}  // namespace
}  // namespace vitrail
