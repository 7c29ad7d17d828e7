#include "scene/read_parts.h"

namespace vitrail {

namespace {

AreaLight read_area(const JsonValue& value) {
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
  if (!shape.has("kind")) {
    shape.fault("has no `kind`", "write a rectangle or a disc");
  } else if (shape.at("kind").word({"rectangle", "disc"}) == 0) {
    light.shape = read_rectangle(shape);
  } else {
    light.shape = read_disc(shape);
  }
  return light;
}

EnvironmentLight read_environment(const JsonValue& value, const std::string& folder) {
  EnvironmentLight light;
  if (value.has("file")) {
    value.object({"name", "kind", "file"});
    light.file = beside(folder, value.at("file").string());
    light.radiance = {1, 1, 1};
  } else {
    value.object({"name", "kind", "radiance"});
    light.radiance = value.at("radiance").colour();
  }
  return light;
}

Emitter read_emitter(const JsonValue& value, const std::string& folder) {
  switch (value.at("kind").word({"directional", "point", "spot", "area", "environment"})) {
    case 1:
      value.object({"name", "kind", "position", "intensity"});
      return PointLight{value.at("position").vector(), value.at("intensity").colour()};
    case 2:
      value.object({"name", "kind", "position", "direction", "intensity", "cone_deg"});
      return SpotLight{value.at("position").vector(), value.at("direction").unit_vector(),
                       value.at("intensity").colour(), value.at("cone_deg").number({0, 180, true})};
    case 3:
      return read_area(value);
    case 4:
      return read_environment(value, folder);
    default:
      break;
  }
  value.object({"name", "kind", "direction", "irradiance", "angular_diameter_deg"});
  return DirectionalLight{value.at("direction").unit_vector(), value.at("irradiance").colour(),
                          value.at("angular_diameter_deg").number({0, 90})};
}

}  // namespace

Light read_light(const JsonValue& value, const std::string& folder) {
  if (!value.is_object() || !value.has("kind")) {
    value.fault("has no `kind`", "write one of directional, point, spot, area, environment");
    return {};
  }
  return {value.at("name").string(), read_emitter(value, folder)};
}

}  // namespace vitrail
