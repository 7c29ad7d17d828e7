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
