/// Rough scattering against its closed distributions [O 1.3].

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "build_scene.h"
#include "optics/roughness.h"

namespace vitrail {
namespace {

std::vector<double> deflections_deg(double lambda, int count) {
  TestNumbers numbers;
  const Vec3 d = normalise({0.3, -0.5, 0.8});
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    const Vec3 bent = deflect(d, lambda, d, {numbers.unit(), numbers.unit(), numbers.unit()});
    angles.push_back(degrees(angle_between(d, bent)));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// Mean, median, 95 % point and maximum in degrees [O 1.3]. 4e5 samples: the mean has an error of width/600.
TEST(Equation8, HasTheTabulatedDeflections) {
  const double table[][5] = {{0.1, 1.1636, 1.0580, 2.5772, 3.0128},
                             {0.3, 3.7418, 3.3442, 8.4863, 10.0080},
                             {0.5, 6.6987, 5.8844, 15.5333, 18.4349},
                             {1.0, 15.9844, 13.5886, 38.3293, 45.0}};
  for (const auto& [lambda, mean, median, most, largest] : table) {
    const auto angles = deflections_deg(lambda, 400000);
    double sum = 0;
    for (double a : angles) sum += a;
    const double tolerance = 0.01 * mean;  // about five standard errors
    EXPECT_NEAR(sum / static_cast<double>(angles.size()), mean, tolerance);
    EXPECT_NEAR(angles[angles.size() / 2], median, tolerance);
    EXPECT_NEAR(angles[angles.size() * 95 / 100], most, tolerance);
    EXPECT_LE(angles.back(), largest * (1 + 1e-12));
  }
}

/// The lobe stays where it was: numbers in [0, 1]^3 instead of on the sphere would let it drift by 6 degrees [O 1.3].
TEST(Equation8, DoesNotDrift) {
  TestNumbers numbers;
  const Vec3 d = normalise({-0.2, 0.9, 0.1});
  Vec3 sum;
  for (int i = 0; i < 400000; ++i) sum += deflect(d, 0.5, d, {numbers.unit(), numbers.unit(), numbers.unit()});
  // Width 8 degrees over sqrt(4e5) samples is 0.013 degrees.
  EXPECT_LT(degrees(angle_between(sum, d)), 0.05);
}

/// Counts in bins against their expectations, as a deviation in units of chi^2's own: (chi^2 - dof) / sqrt(2 dof).
double chi_square_deviation(const std::vector<double>& counts, const std::vector<double>& expected) {
  double chi_square = 0, dof = -1;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] < 20) continue;  // too few for a normal count
    chi_square += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    ++dof;
  }
  return (chi_square - dof) / std::sqrt(2 * dof);
}

// One-sided, once in 30000 for a right sampler; the numbers are the same every time.
constexpr double kChiSquare = 4;
constexpr int kMillion = 1000000;

/// The closed distribution of tan theta [O 1.3].
double share_below(double x, double lambda) {
  const double q = lambda / (2 - lambda);
  if (x >= q) return 1;
  if (x <= 0) return 0;
  const double inner = std::sqrt((1 - x) * (q - x) / ((1 + x) * (q + x)));
  return 1 - 2 / lambda *
                 (std::sqrt(q * q - x * x) / (1 + q) - x * std::acos(x / q) +
                  2 * x * x / std::sqrt(1 - x * x) * std::atanh(inner));
}

/// A million deflections in 40 rings of the closed distribution and 8 directions around it; and their mean stays put.
TEST(Equation8, HasItsClosedDistributionByChiSquare) {
  for (const double lambda : {0.1, 0.5, 0.9}) {
    TestNumbers numbers;
    const Vec3 d = normalise({0.3, -0.5, 0.8});
    const SurfaceFrame frame = surface_frame(d);
    std::vector<double> counts(320), expected(320);
    for (int ring = 0; ring < 40; ++ring) {
      const double width = lambda / (2 - lambda) / 40;
      const double share = share_below((ring + 1) * width, lambda) - share_below(ring * width, lambda);
      for (int sector = 0; sector < 8; ++sector) expected[ring * 8 + sector] = kMillion * share / 8;
    }
    Vec3 sum;
    for (int i = 0; i < kMillion; ++i) {
      const Vec3 bent = deflect(d, lambda, d, {numbers.unit(), numbers.unit(), numbers.unit()});
      sum += bent;
      const double x = dot(bent, frame.u), y = dot(bent, frame.v);
      const double tangent = std::hypot(x, y) / dot(bent, d), turn = std::atan2(y, x) / (2 * kPi) + 0.5;
      const int ring = std::min(39, static_cast<int>(tangent / (lambda / (2 - lambda)) * 40));
      ++counts[static_cast<std::size_t>(ring * 8 + std::min(7, static_cast<int>(turn * 8)))];
    }
    EXPECT_LT(chi_square_deviation(counts, expected), kChiSquare) << lambda;
    // Mean tangents of .02 to .24 over sqrt(1e6) samples, three times that in each of two directions.
    EXPECT_LT(angle_between(sum, d), 4 * 0.5 * lambda / 1000) << lambda;
  }
}

/// Where light on the way arrives by Lambert's law, and in how much of it a bin of cos^2 should hold: equal shares.
std::vector<double> cosines_squared_after(double lambda, bool as_light, int bins) {
  TestNumbers numbers;
  std::vector<double> counts(static_cast<std::size_t>(bins));
  for (int i = 0; i < kMillion; ++i) {
    const double cosine = std::sqrt(numbers.unit());
    const Vec3 way{std::sqrt(1 - cosine * cosine), 0, cosine}, normal{0, 0, 1};
    const std::array<double, 3> u{numbers.unit(), numbers.unit(), numbers.unit()};
    const Vec3 bent =
        as_light ? deflect_light(way, lambda, normal, u, numbers.unit()) : deflect(way, lambda, normal, u);
    ++counts[static_cast<std::size_t>(std::min(bins - 1.0, bins * bent.z * bent.z))];
  }
  return counts;
}

/// Lambert's law is what light in a furnace has. Light deflected as looks are would not keep it.
TEST(Equation8, LeavesLambertsLawAsItIs) {
  constexpr int kBins = 50;
  const std::vector<double> even(kBins, kMillion / double(kBins));
  for (const double lambda : {0.1, 0.5, 1.0}) {
    EXPECT_LT(chi_square_deviation(cosines_squared_after(lambda, true, kBins), even), kChiSquare) << lambda;
    if (lambda < 0.5) continue;  // so little of the light grazes there that a million samples cannot tell
    EXPECT_GT(chi_square_deviation(cosines_squared_after(lambda, false, kBins), even), 3 * kChiSquare) << lambda;
  }
}

/// As often from one angle to another as back, weighed by their cosines: counts of Lambert's light over pairs of bins.
TEST(Equation8, TakesLightAsOftenToAsFro) {
  constexpr std::size_t kBins = 8;
  TestNumbers numbers;
  std::array<std::array<double, kBins>, kBins> moved{};
  const auto bin = [](double cosine) { return std::min(kBins - 1, static_cast<std::size_t>(kBins * cosine * cosine)); };
  for (int i = 0; i < kMillion; ++i) {
    const double cosine = std::sqrt(numbers.unit());
    const Vec3 way{std::sqrt(1 - cosine * cosine), 0, cosine};
    const Vec3 bent =
        deflect_light(way, 1, {0, 0, 1}, {numbers.unit(), numbers.unit(), numbers.unit()}, numbers.unit());
    ++moved[bin(cosine)][bin(bent.z)];
  }
  for (std::size_t from = 0; from < kBins; ++from) {
    for (std::size_t to = 0; to < from; ++to) {
      const double there = moved[from][to], back = moved[to][from];
      // A difference of two counts; 28 pairs at four standard errors alarm in 0.2 % of streams.
      EXPECT_LE(std::abs(there - back), 4 * std::sqrt(there + back)) << from << " " << to;
    }
  }
}

TEST(Equation8, LeavesTheDirectionAloneAtZero) {
  const Vec3 d = normalise({1, 2, 3});
  EXPECT_EQ(deflect(d, 0, {0, 1, 0}, {0.3, 0.4, 0.5}), d);
  EXPECT_LT(length(deflect(d, 1e-12, {0, 1, 0}, {0.9, 0.4, 0.5}) - d), 2e-12);
}

TEST(Equation8, StaysOnItsSideOfTheSurface) {
  TestNumbers numbers;
  const Vec3 normal{0, 1, 0}, grazing = normalise({1, 0.02, 0});
  for (int i = 0; i < 10000; ++i) {
    const Vec3 bent = deflect(grazing, 1, normal, {numbers.unit(), numbers.unit(), numbers.unit()});
    EXPECT_GE(bent.y, 0);
    EXPECT_NEAR(length(bent), 1, 1e-15);
  }
}

/// From straight above all facets are visible in proportion to their projection: P(tan theta > x) = a^2 / (a^2 + x^2).
TEST(Ggx, HasItsSlopesFromAbove) {
  TestNumbers numbers;
  const Vec3 normal = normalise({0.1, 0.7, -0.3});
  const double alpha = 0.2;
  int above_alpha = 0, above_twice = 0;
  constexpr int kCount = 400000;
  for (int i = 0; i < kCount; ++i) {
    const Vec3 m = ggx_normal(normal, normal, alpha, numbers.unit(), numbers.unit());
    const double tangent = std::tan(angle_between(m, normal));
    above_alpha += tangent > alpha;
    above_twice += tangent > 2 * alpha;
  }
  // Binomial standard errors are 0.0008 and 0.0006; four of these.
  EXPECT_NEAR(above_alpha / double(kCount), 0.5, 0.0032);
  EXPECT_NEAR(above_twice / double(kCount), 0.2, 0.0026);
}

/// A million visible normals in cells of 24 heights by 24 directions against D G1 max(0, v.m) / (n.v), integrated over
/// each cell [W07 eq. 33; Heitz 2018].
TEST(Ggx, HasItsVisibleNormalsByChiSquare) {
  constexpr int kSide = 24, kSteps = 24;
  for (const auto& [alpha, angle] : {std::pair{0.1, 0.0}, std::pair{0.3, 60.0}, std::pair{0.8, 80.0}}) {
    const Vec3 normal{0, 0, 1}, viewer{std::sin(radians(angle)), 0, std::cos(radians(angle))};
    const double tan_viewer = std::tan(radians(angle));
    const double masking = 2 / (1 + std::sqrt(1 + alpha * alpha * tan_viewer * tan_viewer));
    const auto density = [&](double cosine, double turn) {
      const double sine = std::sqrt(1 - cosine * cosine);
      const double toward = std::max(0.0, viewer.x * sine * std::cos(turn) + viewer.z * cosine);
      const double spread = cosine * cosine * (alpha * alpha - 1) + 1;
      return alpha * alpha / (kPi * spread * spread) * masking * toward / viewer.z;
    };
    // Heights in equal shares of D cos, so that no cell is empty: cos^2 of the share u is (1 - u) / (1 + (a^2 - 1) u).
    const auto cosine_at = [&](double u) { return std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u)); };
    std::vector<double> counts(kSide * kSide), expected(kSide * kSide);
    for (int i = 0; i < kSide * kSteps; ++i) {
      const double high = cosine_at(double(i) / (kSide * kSteps)), low = cosine_at((i + 1.0) / (kSide * kSteps));
      for (int j = 0; j < kSide * kSteps; ++j) {
        const double turn = 2 * kPi * (j + 0.5) / (kSide * kSteps);
        expected[static_cast<std::size_t>(i / kSteps * kSide + j / kSteps)] +=
            kMillion * density(0.5 * (high + low), turn) * (high - low) * 2 * kPi / (kSide * kSteps);
      }
    }
    TestNumbers numbers;
    for (int i = 0; i < kMillion; ++i) {
      const Vec3 m = ggx_normal(viewer, normal, alpha, numbers.unit(), numbers.unit());
      const double square = m.z * m.z, u = (1 - square) / (1 + (alpha * alpha - 1) * square);
      const double turn = std::atan2(m.y, m.x) / (2 * kPi), j = (turn < 0 ? turn + 1 : turn) * kSide;
      const int row = std::min(kSide - 1, static_cast<int>(u * kSide)),
                column = std::min(kSide - 1, static_cast<int>(j));
      ++counts[static_cast<std::size_t>(row * kSide + column)];
    }
    EXPECT_LT(chi_square_deviation(counts, expected), kChiSquare) << alpha << " " << angle;
  }
}

/// At any angle, visible facets satisfy E[1 / G1-weighted cosines] such that the mean of m.v / (v.n) over all facets
/// is G1-normalised: sampled normals always face the viewer.
TEST(Ggx, ShowsOnlyFacetsThatFaceTheViewer) {
  TestNumbers numbers;
  const Vec3 normal{0, 0, 1};
  for (double angle : {0.0, 30.0, 60.0, 85.0}) {
    const Vec3 viewer{std::sin(radians(angle)), 0, std::cos(radians(angle))};
    for (int i = 0; i < 20000; ++i) {
      const Vec3 m = ggx_normal(viewer, normal, 0.4, numbers.unit(), numbers.unit());
      EXPECT_GT(dot(m, viewer), -1e-12);
      EXPECT_GT(m.z, 0);
    }
  }
}

}  // namespace
}  // namespace vitrail
