#pragma once
/// Large arrays of numbers that begin as zeros.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace vitrail {

/// The system hands out zeros, a page when it is first written to: what stays zero takes no memory and no time.
template <typename Number>
class Zeros {
 public:
  explicit Zeros(std::size_t count)
      : values_(static_cast<Number*>(std::calloc(std::max<std::size_t>(count, 1), sizeof(Number)))) {
    if (!values_) throw std::bad_alloc();
  }
  Number* data() { return values_.get(); }
  const Number* data() const { return values_.get(); }
  Number& operator[](std::size_t i) { return values_.get()[i]; }
  const Number& operator[](std::size_t i) const { return values_.get()[i]; }

 private:
  struct Free {
    void operator()(Number* values) const { std::free(values); }
  };
  std::unique_ptr<Number[], Free> values_;
};

}  // namespace vitrail
