/// Light on a face of facets: nothing lost, and the way back as likely as the way there [H16].

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "build_scene.h"
#include "optics/microsurface.h"

namespace vitrail {
namespace {

constexpr double kIndex = 1.5;

struct Exit {
  Vec3 direction;  // z on the side from which the light came
  bool behind = false;
};

Exit sent(Vec3 direction, const IndexPair& index, const Facets& facets, Stream stream) {
  FacetRay ray{direction, index};
  EXPECT_EQ(leave_facets(ray, facets, direction, stream), 1);
  return {ray.behind ? -ray.direction : ray.direction, ray.behind};
}

/// Rays by Lambert's law on both sides, n^2 as many inside, by side and cos^2: what goes from one cell to
/// another is what comes back. A cell is an equal share of its side's light.
TEST(Facets, SendAsMuchBackAsThere) {
  constexpr std::size_t kCells = 6, kStates = 2 * kCells;
  constexpr int kOutside = 100000, kInside = static_cast<int>(kOutside * kIndex * kIndex);
  const IndexPair in{1, kIndex, 0, kIndex - 1}, out{kIndex, 1, kIndex - 1, 0};
  std::uint64_t run = 0;
  for (const FacetLaw law : {FacetLaw::mirror, FacetLaw::let_through, FacetLaw::divide_by_fresnel}) {
    for (const double alpha : {0.05, 0.3, 1.0}) {
      std::array<std::array<double, kStates>, kStates> flow{};
      const Stream stream = stream_of(++run, Purpose::kPilot);
      for (int i = 0; i < kOutside + kInside; ++i) {
        const bool inside = i >= kOutside;
        const Stream one = within(stream, static_cast<std::uint64_t>(i));
        const double square = uniform(one, 0, 5), sine = std::sqrt(1 - square), turn = 2 * kPi * uniform(one, 0, 6);
        const Vec3 way{sine * std::cos(turn), sine * std::sin(turn), -std::sqrt(square)};
        const Exit exit = sent(way, inside ? out : in, {alpha, law}, one);
        EXPECT_EQ(exit.direction.z > 0, !exit.behind);
        const auto cell = [](double cosine, bool at_inside) {
          const auto share = static_cast<std::size_t>(cosine * cosine * kCells);
          return std::min(share, kCells - 1) + (at_inside ? kCells : 0);
        };
        ++flow[cell(way.z, inside)][cell(exit.direction.z, inside != exit.behind)];
      }

      // Each pair of cells is two counts of one mean: the square of their difference over their sum is 1 on average.
      double chi_square = 0, pairs = 0;
      for (std::size_t a = 0; a < kStates; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          const double there = flow[a][b], back = flow[b][a];
          if (there + back < 40) continue;  // too few for a normal count
          chi_square += (there - back) * (there - back) / (there + back);
          ++pairs;
        }
      }
      EXPECT_GT(pairs, 10);
      EXPECT_LT((chi_square - pairs) / std::sqrt(2 * pairs), 4) << static_cast<int>(law) << " " << alpha;
    }
  }
}

/// From outside panes let everything in, from inside 1/n^2 of what comes by Lambert's law gets out.
TEST(Facets, LetOutWhatReciprocityAllows) {
  constexpr int kRays = 200000;
  for (const double alpha : {0.05, 0.3, 1.0}) {
    int through_in = 0, through_out = 0;
    const Stream stream = stream_of(1, Purpose::kPilot);
    for (int i = 0; i < kRays; ++i) {
      const Stream one = within(stream, static_cast<std::uint64_t>(i));
      const double square = uniform(one, 0, 5);
      const Vec3 way{std::sqrt(1 - square), 0, -std::sqrt(square)};
      const Facets panes{alpha, FacetLaw::let_through};
      through_in += sent(way, {1, kIndex, 0, kIndex - 1}, panes, one).behind;
      through_out += sent(way, {kIndex, 1, kIndex - 1, 0}, panes, one).behind;
    }
    // Light that has got in and is mirrored totally at another facet may get out again: nearly all gets in.
    const double in = through_in / double(kRays), out = through_out / double(kRays);
    EXPECT_GT(in, 0.99) << alpha;
    // Four standard errors of a share of 0.44 are 0.0044.
    EXPECT_NEAR(out, in / (kIndex * kIndex), 0.0045) << alpha;
  }
}

TEST(Facets, OfNoRoughnessAreTheSmoothFace) {
  const Vec3 way = normalise({0.6, 0.1, -0.5});
  const IndexPair index{1, kIndex, 0, kIndex - 1};
  const Exit mirrored = sent(way, index, {1e-9, FacetLaw::mirror}, {1});
  const Exit bent = sent(way, index, {1e-9, FacetLaw::let_through}, {1});
  // Slopes of the order of 1e-9, far out in the tail some hundred times that.
  EXPECT_LT(length(mirrored.direction - reflect(way, {0, 0, 1})), 1e-6);
  EXPECT_LT(length(bent.direction - refract(way, {0, 0, 1}, index).direction), 1e-6);
  EXPECT_TRUE(bent.behind);
}

}  // namespace
}  // namespace vitrail
