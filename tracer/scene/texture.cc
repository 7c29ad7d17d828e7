#include <algorithm>
#include <cmath>

#include "scene/scene.h"

namespace vitrail {

Rgb texture_at(const Texture& texture, double s, double t) {
  if (const Rgb* colour = std::get_if<Rgb>(&texture)) return *colour;
  const Checker& checker = std::get<Checker>(texture);

  // Take the parity of each floor by itself: their sum may not fit an integer far from the origin.
  const double column = std::floor(s / checker.size), row = std::floor(t / checker.size);
  const bool odd = (std::fmod(column, 2) != 0) != (std::fmod(row, 2) != 0);
  return checker.colors[odd];
}

Rgb texture_peak(const Texture& texture) {
  if (const Rgb* colour = std::get_if<Rgb>(&texture)) return *colour;
  const auto& [first, second] = std::get<Checker>(texture).colors;
  return {std::max(first.r, second.r), std::max(first.g, second.g), std::max(first.b, second.b)};
}

}  // namespace vitrail
