/// Sines and cosines by their series against the library's.

#include <gtest/gtest.h>

#include "base/sine_cosine.h"

namespace vitrail {
namespace {

TEST(SineCosine, OfATurnIsTheLibrarys) {
  // The library is right to half a unit of its last digit; the angle it is asked for has an error of 2 pi 2^-53 itself.
  constexpr double kRounding = 1e-15;
  for (int i = 0; i <= 4096; ++i) {
    const double turn = i / 4096.0;
    const auto [sine, cosine] = sine_cosine_of_turn(turn);
    EXPECT_NEAR(sine, std::sin(2 * M_PI * turn), kRounding) << turn;
    EXPECT_NEAR(cosine, std::cos(2 * M_PI * turn), kRounding) << turn;
  }
}

/// Whole quarters of a turn leave no rounding.
TEST(SineCosine, OfQuartersIsExact) {
  for (int quarter = 0; quarter <= 4; ++quarter) {
    const auto [sine, cosine] = sine_cosine_of_turn(quarter / 4.0);
    EXPECT_EQ(sine, quarter % 4 == 1 ? 1 : quarter % 4 == 3 ? -1 : 0);
    EXPECT_EQ(cosine, quarter % 4 == 0 ? 1 : quarter % 4 == 2 ? -1 : 0);
  }
}

}  // namespace
}  // namespace vitrail
