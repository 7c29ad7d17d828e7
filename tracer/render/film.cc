#include "render/film.h"

#include <stdexcept>

namespace vitrail {

const char* name_of(Layer layer) {
  switch (layer) {
    case Layer::diffusion:
      return "diffusion";
    case Layer::reflection:
      return "reflection";
    case Layer::refraction:
      return "refraction";
    case Layer::total_internal_reflection:
      return "total_internal_reflection";
    case Layer::caustic:
      return "caustic";
    case Layer::indirect_light:
      return "indirect_light";
  }
  throw std::logic_error("no such layer");
}

bool is_planned(Layer layer, const Plan& plan) {
  switch (layer) {
    case Layer::diffusion:
      return plan.diffusion;
    case Layer::reflection:
      return plan.reflection;
    case Layer::refraction:
      return plan.refraction;
    case Layer::total_internal_reflection:
      return plan.total_internal_reflection;
    case Layer::caustic:
      return plan.caustic;
    case Layer::indirect_light:
      return plan.indirect_light;
  }
  throw std::logic_error("no such layer");
}

int planned_layers(const Plan& plan) {
  int count = 0;
  for (int l = 0; l < kLayerCount; ++l) count += is_planned(static_cast<Layer>(l), plan);
  return count;
}

Rgb HalfPixel::radiance() const {
  Rgb sum;
  for (const Rgb& layer : layers) sum += layer;
  return sum;
}

Film::Film(int width, int height)
    : width_(width),
      height_(height),
      values_(3 * kGroups * pixels()),
      lit_(std::make_unique<std::array<std::atomic<bool>, kLayerCount>>()) {}

void Film::add(int half, int x, int y, const HalfPixel& light) {
  const Rgb radiance = light.radiance();
  if (is_black(radiance)) return;
  const std::size_t at = index(x, y);
  for (int l = 0; l < kLayerCount; ++l) add_to(static_cast<Layer>(l), at, light.layers[l]);
  add_to(half, at, radiance);
}

void Film::add(int half, int x, int y, Layer layer, Rgb light) {
  const std::size_t at = index(x, y);
  add_to(layer, at, light);
  add_to(half, at, light);
}

void Film::add_to(Layer layer, std::size_t at, Rgb light) {
  if (is_black(light)) return;
  std::atomic<bool>& lit = (*lit_)[static_cast<std::size_t>(layer)];
  if (!lit.load(std::memory_order_relaxed)) lit.store(true, std::memory_order_relaxed);
  add_to(group_of(layer), at, light * 0.5);
}

void Film::add_to(int group, std::size_t at, Rgb light) {
  if (is_black(light)) return;
  for (int c = 0; c < 3; ++c) plane(group, c)[at] = static_cast<float>(plane(group, c)[at] + light[c]);
}

std::uint64_t Film::predicted_bytes(int width, int height, int layers) {
  const std::uint64_t planes = 3 * (2 + static_cast<std::uint64_t>(layers));
  return planes * sizeof(float) * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

}  // namespace vitrail
