#include <limits>

#include "scene/read_parts.h"

namespace vitrail {

namespace {

Emitter read_directional(const JsonValue& value) {
  value.object({"name", "kind", "direction", "irradiance", "angular_diameter_deg"});
  return DirectionalLight{value.at("direction").unit_vector(), value.at("irradiance").colour(),
                          value.at("angular_diameter_deg").number({0, 90})};
}

Emitter read_point(const JsonValue& value) {
  value.object({"name", "kind", "position", "intensity"});
  return PointLight{value.at("position").vector(), value.at("intensity").colour()};
}

Emitter read_spot(const JsonValue& value) {
  value.object({"name", "kind", "position", "direction", "intensity", "cone_deg"});
  return SpotLight{value.at("position").vector(), value.at("direction").unit_vector(), value.at("intensity").colour(),
                   value.at("cone_deg").number({0, 180, true})};
}

using Lamp = decltype(AreaLight::shape);

template <typename Part>
Lamp read_lamp(const JsonValue& value) {
  return Part::read(value);
}

constexpr Choice<Lamp (*)(const JsonValue&)> kLamps[] = {{"rectangle", read_lamp<RectangleShape>},
                                                         {"disc", read_lamp<DiscShape>}};

Emitter read_area(const JsonValue& value) {
  AreaLight light;
  light.collimated = value.has("collimated") && value.at("collimated").boolean();
  if (light.collimated) {
    value.object({"name", "kind", "shape", "collimated", "irradiance"});
    light.irradiance = value.at("irradiance").colour();
  } else {
    value.object({"name", "kind", "shape", "radiance"}, {"collimated"});
    light.radiance = value.at("radiance").colour();
  }

  const JsonValue shape = value.at("shape");
  if (shape.has("kind"))
    light.shape = shape.at("kind").choice(kLamps)(shape);
  else
    shape.fault("has no `kind`", "write a rectangle or a disc");
  return light;
}

/// Pixels of the largest sky: 8192 x 4096.
constexpr std::int64_t kMostSkyPixels = std::int64_t{1} << 25;

/// A lat-long image in rows from the top: three floats a pixel.
std::shared_ptr<const SkyImage> read_sky(const JsonValue& value) {
  value.object({"width", "height", "radiance"});
  const auto width = static_cast<int>(value.at("width").integer(1, kMostSkyPixels));
  const auto height = static_cast<int>(value.at("height").integer(1, kMostSkyPixels / width));
  const JsonValue radiance = value.at("radiance");
  const std::vector<float> numbers = radiance.packed<float>();
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (numbers.size() != 3 * pixels) {
    radiance.fault("holds " + std::to_string(numbers.size()) + " numbers", "pack three for each pixel");
    return std::make_shared<const SkyImage>(1, 1, std::vector<Rgb>(1));
  }
  std::vector<Rgb> sky(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    sky[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    if (sky[i].r >= 0 && sky[i].g >= 0 && sky[i].b >= 0 &&
        largest_channel(sky[i]) < std::numeric_limits<double>::infinity())
      continue;
    radiance.fault("holds a pixel that is negative or not finite", "pack radiance");
    break;
  }
  return std::make_shared<const SkyImage>(width, height, std::move(sky));
}

Emitter read_environment(const JsonValue& value) {
  EnvironmentLight light;
  if (value.has("image")) {
    value.object({"name", "kind", "image"});
    light.image = read_sky(value.at("image"));
    light.radiance = {1, 1, 1};
  } else {
    value.object({"name", "kind", "radiance"});
    light.radiance = value.at("radiance").colour();
  }
  return light;
}

constexpr Choice<Emitter (*)(const JsonValue&)> kEmitters[] = {{"directional", read_directional},
                                                               {"point", read_point},
                                                               {"spot", read_spot},
                                                               {"area", read_area},
                                                               {"environment", read_environment}};
static_assert(std::size(kEmitters) == std::variant_size_v<Emitter>, "every light has a name in the scene file");

}  // namespace

Light read_light(const JsonValue& value) {
  if (!value.is_object() || !value.has("kind")) {
    value.fault("has no `kind`", "write one of directional, point, spot, area, environment");
    return {};
  }
  return {value.at("name").string(), value.at("kind").choice(kEmitters)(value)};
}

}  // namespace vitrail
