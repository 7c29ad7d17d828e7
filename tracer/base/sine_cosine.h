#pragma once
/// Sine and cosine by their series: the same bits on every machine, whatever its library holds to be the last digit.

#include <cmath>
#include <initializer_list>

namespace vitrail {

struct SineCosine {
  double sine, cosine;
};

/// For |x| <= pi/4, to below the rounding of a double.
inline SineCosine sine_cosine(double x) {
  const double y = x * x;
  double sine = -1.0 / 1307674368000;  // 1 / 15!
  for (const double c : {1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6, 1.0}) {
    sine = sine * y + c;
  }
  double cosine = 1.0 / 20922789888000;  // 1 / 16!
  for (const double c :
       {-1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320, -1.0 / 720, 1.0 / 24, -0.5, 1.0}) {
    cosine = cosine * y + c;
  }
  return {sine * x, cosine};
}

/// Of the angle 2 pi `turn`, for a turn in [0, 1]: whole quarters are taken off first, which is exact.
inline SineCosine sine_cosine_of_turn(double turn) {
  const int quarters = static_cast<int>(4 * turn + 0.5);
  const auto [sine, cosine] = sine_cosine(2 * M_PI * (turn - 0.25 * quarters));
  const bool swapped = (quarters & 1) != 0;
  const double s = swapped ? cosine : sine, c = swapped ? sine : cosine;
  return {(quarters & 2) != 0 ? -s : s, ((quarters + 1) & 2) != 0 ? -c : c};
}

}  // namespace vitrail
