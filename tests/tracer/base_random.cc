// The stateless random numbers: known Sobol values, the net property, independence of streams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "base/random.h"

namespace vitrail {
namespace {

// The first eight points as printed by Joe and Kuo (2008) for new-joe-kuo-6, in 32-bit fractions. Their Gray-code order
// and ours (plain order of the index) list the same points; these are in plain order.
TEST(Sobol, FirstPointsAreThePublishedOnes) {
  const double expected[8][4] = {{0, 0, 0, 0},
                                 {.5, .5, .5, .5},
                                 {.25, .75, .75, .75},
                                 {.75, .25, .25, .25},
                                 {.125, .625, .375, .125},
                                 {.625, .125, .875, .625},
                                 {.375, .375, .625, .875},
                                 {.875, .875, .125, .375}};
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (int d = 0; d < 4; ++d)
      EXPECT_EQ(sobol_bits(i)[d] * 0x1p-32, expected[i][d]) << "index " << i << " dimension " << d;
  }
}

// An aligned block of 2^8 points has exactly one point in each elementary box of area 2^-8 (t = 0), scrambled or not.
TEST(Sobol, EveryAlignedBlockIsANet) {
  const Stream stream = stream_of(7, Purpose::kEmissionPosition);
  for (std::uint32_t block : {0u, 1u, 77u, 4000000u}) {
    for (int bits_x = 0; bits_x <= 8; ++bits_x) {
      std::set<int> cells;
      for (std::uint32_t i = 0; i < 256; ++i) {
        const auto p = sobol_2d(stream, block * 256 + i);
        const int cx = static_cast<int>(p[0] * (1 << bits_x)), cy = static_cast<int>(p[1] * (1 << (8 - bits_x)));
        cells.insert(cx * 256 + cy);
      }
      EXPECT_EQ(cells.size(), 256u) << "block " << block << " split " << bits_x;
    }
  }
}

// Quasi-random integration of a smooth function is far better than the random N^-1/2 = 4e-3 at 2^16 points.
TEST(Sobol, IntegratesASmoothFunctionInFourDimensions) {
  const Stream stream = stream_of(1, Purpose::kEmissionDirection, 3);
  double sum = 0;
  for (std::uint32_t i = 0; i < 65536; ++i) {
    const auto p = sobol_4d(stream, i);
    sum += 16 * p[0] * p[1] * p[2] * p[3];
  }
  EXPECT_NEAR(sum / 65536, 1.0, 5e-5);
}

// Points of one index from two streams, joined, must fill the square: the padded ones do, plain ones lie on few
// diagonals.
TEST(Padding, JoinsStreamsWithoutCorrelation) {
  const Stream first = stream_of(1, Purpose::kPixel), second = within(first, 7);
  std::set<int> padded, plain;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    const auto a = sobol_2d(first, i), b = padded_2d(second, i), c = sobol_2d(second, i);
    padded.insert(static_cast<int>(a[0] * 32) * 32 + static_cast<int>(b[0] * 32));
    plain.insert(static_cast<int>(a[0] * 32) * 32 + static_cast<int>(c[0] * 32));
  }
  EXPECT_GT(padded.size(), 980u);  // of 1024 cells with four points each; random points leave 19 empty
  EXPECT_LT(plain.size(), 100u);
}

TEST(Padding, KeepsEveryAlignedBlockANet) {
  const Stream stream = stream_of(3, Purpose::kLightSample);
  std::set<int> cells;
  for (std::uint32_t i = 512; i < 768; ++i) {
    const auto p = padded_2d(stream, i);
    cells.insert(static_cast<int>(p[0] * 16) * 16 + static_cast<int>(p[1] * 16));
  }
  EXPECT_EQ(cells.size(), 256u);
}

// Two scramblings are two independent estimates: their errors must not be correlated, or half-images would lie about
// the noise. The correlation of 256 pairs of errors has standard deviation 1/16; 4 of these are allowed.
TEST(Streams, TwoHalvesAreIndependent) {
  double ab = 0, aa = 0, bb = 0;
  for (std::uint64_t seed = 0; seed < 256; ++seed) {
    double error[2] = {0, 0};
    for (std::uint64_t half = 0; half < 2; ++half) {
      const Stream stream = stream_of(seed, Purpose::kEmissionPosition, 0, half);
      for (std::uint32_t i = 0; i < 100; ++i) {
        const auto p = sobol_2d(stream, i);
        error[half] += (p[0] * p[0] + p[1] * p[1] < 0.5) - M_PI / 8;
      }
    }
    ab += error[0] * error[1];
    aa += error[0] * error[0];
    bb += error[1] * error[1];
  }
  EXPECT_LT(std::abs(ab) / std::sqrt(aa * bb), 4.0 / 16);
}

// 1e5 uniform numbers in 100 bins: chi-square with 99 degrees of freedom stays under 160 except once in 1e4 seeds.
TEST(Uniform, FillsTheUnitIntervalEvenly) {
  const Stream stream = stream_of(5, Purpose::kRoulette);
  std::vector<int> bins(100);
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double u = uniform(stream, i / 10, static_cast<std::uint32_t>(i % 10));
    ASSERT_GT(u, 0);
    ASSERT_LT(u, 1);
    ++bins[static_cast<int>(u * 100)];
  }
  double chi_square = 0;
  for (int count : bins) chi_square += (count - 1000.0) * (count - 1000.0) / 1000;
  EXPECT_LT(chi_square, 160);
  EXPECT_GT(chi_square, 50);
}

TEST(Uniform, IsAPureFunction) {
  const Stream a = stream_of(1, Purpose::kRoulette, 2, 3), b = stream_of(1, Purpose::kRoulette, 3, 2);
  EXPECT_EQ(uniform(a, 5, 6), uniform(a, 5, 6));
  EXPECT_NE(uniform(a, 5, 6), uniform(b, 5, 6));
  EXPECT_NE(uniform(a, 5, 6), uniform(a, 6, 5));
}

}  // namespace
}  // namespace vitrail
