#pragma once
/// Sums and products together with their rounding error, for the few differences that must not cancel.

#include <cmath>

namespace vitrail {

/// value + error is the exact result.
struct Exact {
  double value = 0, error = 0;
};

inline Exact exact_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

inline Exact exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

}  // namespace vitrail
