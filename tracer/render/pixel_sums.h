#pragma once
/// Light that is counted in the pixels of one half, summed in double on its way to the film.

#include "base/zeros.h"
#include "render/film.h"

namespace vitrail {

class PixelSums {
 public:
  explicit PixelSums(const Film& film)
      : width_(static_cast<std::size_t>(film.width())), sums_(width_ * static_cast<std::size_t>(film.height())) {}

  void add(int x, int y, Rgb light) {
    sums_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)] += light;
  }

  /// Add the sums to a layer of one half.
  void develop(Film& film, int half, Layer layer) const {
    const Rgb* sum = sums_.data();
    for (int y = 0; y < film.height(); ++y) {
      for (int x = 0; x < film.width(); ++x) film.add(half, x, y, layer, *sum++);
    }
  }

  static std::uint64_t predicted_bytes(int width, int height) {
    return sizeof(Rgb) * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }

 private:
  std::size_t width_;
  Zeros<Rgb> sums_;
};

}  // namespace vitrail
