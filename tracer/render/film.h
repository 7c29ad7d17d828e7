#pragma once
/// Radiance per pixel, in two independent halves and in layers by phenomenon.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

#include "base/vec3.h"
#include "base/zeros.h"
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
int planned_layers(const Plan& plan);

/// Light in one pixel of one half, layer by layer.
struct HalfPixel {
  std::array<Rgb, kLayerCount> layers;

  Rgb& operator[](Layer layer) { return layers[static_cast<std::size_t>(layer)]; }
  Rgb radiance() const;
};

/// Planes of floats that begin black: the radiance of each half, and the mean of the halves for each layer. A plane
/// takes memory where something was added to it, and nowhere else.
class Film {
 public:
  Film(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }

  /// Add light to a pixel of a half. Threads may do so at once in different pixels.
  void add(int half, int x, int y, const HalfPixel& light);
  void add(int half, int x, int y, Layer layer, Rgb light);

  /// The radiance of one half, the mean of both, and the part of it in one layer, W / (sr m2).
  Rgb half(int half, int x, int y) const { return pixel(half, x, y); }
  Rgb radiance(int x, int y) const { return (half(0, x, y) + half(1, x, y)) * 0.5; }
  Rgb layer(Layer layer, int x, int y) const { return pixel(group_of(layer), x, y); }

  /// Whether anything but black was ever added to a layer.
  bool is_lit(Layer layer) const { return (*lit_)[static_cast<std::size_t>(layer)].load(std::memory_order_relaxed); }

  /// One colour of a half or of a layer, row by row from the top.
  const float* half_plane(int half, int colour) const { return plane(half, colour); }
  const float* layer_plane(Layer layer, int colour) const { return plane(group_of(layer), colour); }

  /// Bytes of a film with so many layers that are lit everywhere.
  static std::uint64_t predicted_bytes(int width, int height, int layers);

 private:
  // The halves and the layers are groups of three planes.
  static constexpr int kGroups = 2 + kLayerCount;
  static int group_of(Layer layer) { return 2 + static_cast<int>(layer); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  std::size_t pixels() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }
  float* plane(int group, int colour) {
    return values_.data() + static_cast<std::size_t>(3 * group + colour) * pixels();
  }
  const float* plane(int group, int colour) const {
    return values_.data() + static_cast<std::size_t>(3 * group + colour) * pixels();
  }
  Rgb pixel(int group, int x, int y) const {
    const std::size_t at = index(x, y);
    return {plane(group, 0)[at], plane(group, 1)[at], plane(group, 2)[at]};
  }
  void add_to(int group, std::size_t at, Rgb light);
  void add_to(Layer layer, std::size_t at, Rgb light);

  int width_, height_;
  Zeros<float> values_;
  std::unique_ptr<std::array<std::atomic<bool>, kLayerCount>> lit_;
};

}  // namespace vitrail
