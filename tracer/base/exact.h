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

/// A sum of many terms with about twice the digits of a double.
class ExactSum {
 public:
  void add(double term) {
    const Exact next = exact_sum(sum_, term);
    sum_ = next.value;
    error_ += next.error;
  }
  void add_product(double a, double b) {
    const Exact product = exact_product(a, b);
    add(product.value);
    error_ += product.error;
  }
  double value() const { return sum_ + error_; }

 private:
  double sum_ = 0, error_ = 0;
};

}  // namespace vitrail
