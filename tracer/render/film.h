#pragma once
/// Radiance per pixel, in two independent halves and in layers by phenomenon.

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "scene/scene.h"

namespace vitrail {

/// Where light on a camera path belongs. Light gathered from the caustic map is caustic, from the global map or ambient
/// indirect_light; direct light and emission: seen directly diffusion, on a path with total internal reflection that,
/// else by the first specular event.
enum class Layer : std::uint8_t {
  diffusion,
  reflection,
  refraction,
  total_internal_reflection,
  caustic,
  indirect_light,
};
inline constexpr int kLayerCount = 6;
const char* name_of(Layer layer);

/// Whether the plan renders a layer at all; the others stay black and are not written.
bool is_planned(Layer layer, const Plan& plan);

/// One pixel of one half: the mean over the half's samples, layer by layer.
struct HalfPixel {
  std::array<Rgb, kLayerCount> layers;

  Rgb& operator[](Layer layer) { return layers[static_cast<std::size_t>(layer)]; }
  Rgb radiance() const;
};

class Film {
 public:
  Film(int width, int height) : width_(width), height_(height) {
    for (auto& half : halves_) half.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }
  int width() const { return width_; }
  int height() const { return height_; }
  HalfPixel& at(int half, int x, int y) { return halves_[half][index(x, y)]; }
  const HalfPixel& at(int half, int x, int y) const { return halves_[half][index(x, y)]; }

  /// The mean of the two halves, whole or of one layer, W / (sr m2).
  Rgb radiance(int x, int y) const;
  Rgb layer(Layer layer, int x, int y) const;

  static std::uint64_t predicted_bytes(int width, int height);

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_, height_;
  std::array<std::vector<HalfPixel>, 2> halves_;
};

}  // namespace vitrail
