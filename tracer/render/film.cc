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

Rgb HalfPixel::radiance() const {
  Rgb sum;
  for (const Rgb& layer : layers) sum += layer;
  return sum;
}

Rgb Film::radiance(int x, int y) const { return (at(0, x, y).radiance() + at(1, x, y).radiance()) * 0.5; }

Rgb Film::layer(Layer layer, int x, int y) const {
  const auto l = static_cast<std::size_t>(layer);
  return (at(0, x, y).layers[l] + at(1, x, y).layers[l]) * 0.5;
}

std::uint64_t Film::predicted_bytes(int width, int height) {
  return 2 * sizeof(HalfPixel) * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

}  // namespace vitrail
