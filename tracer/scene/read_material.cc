#include <cmath>

#include "scene/read_parts.h"

namespace vitrail {

namespace {

Texture read_texture(const JsonValue& value, Range range) {
  if (!value.is_object()) return value.colour(range);
  Checker checker;
  value.object({"checker"});
  const JsonValue squares = value.at("checker");
  squares.object({"colors", "size"});
  const std::vector<JsonValue> colors = squares.at("colors").array(2);
  if (!colors.empty()) checker.colors = {colors[0].colour(range), colors[1].colour(range)};
  checker.size = squares.at("size").number(Range::positive());
  return checker;
}

Roughness read_smooth(const JsonValue& value) {
  value.object({"kind"});
  return NoRoughness{};
}

Roughness read_equation_8(const JsonValue& value) {
  value.object({"kind", "value"});
  return Equation8{value.at("value").number(Range::share())};
}

Roughness read_ggx(const JsonValue& value) {
  value.object({"kind", "alpha"});
  return Ggx{value.at("alpha").number({0, 1, true})};
}

constexpr Choice<Roughness (*)(const JsonValue&)> kRoughness[] = {
    {"none", read_smooth}, {"equation_8", read_equation_8}, {"ggx", read_ggx}};
static_assert(std::size(kRoughness) == std::variant_size_v<Roughness>, "every roughness has a name in the scene file");

Roughness read_roughness(const JsonValue& value) {
  if (!value.is_object() || !value.has("kind")) {
    value.fault("has no `kind`", "write {\"kind\": \"none\"} for a smooth face");
    return NoRoughness{};
  }
  return value.at("kind").choice(kRoughness)(value);
}

std::vector<double> read_indices(const JsonValue& value, std::size_t bands, Range range) {
  std::vector<double> indices;
  for (const JsonValue& index : value.array(static_cast<int>(bands))) indices.push_back(index.number(range));
  indices.resize(bands, 1.0);
  return indices;
}

/// lu = d + r + t may not make light [S eq. 6]; decimal sums overshoot 1 by up to 4 ulp, which is allowed [O 2.37].
void refuse_light_making(const JsonValue& value, const Material& material) {
  const Rgb use = texture_peak(material.diffuse) + material.reflection + material.transmission;
  if (!(largest_channel(use) <= 1 + 4 * 2.220446049250313e-16))
    value.fault("makes light: diffuse + reflection + transmission is above 1", "lower one of them");
}

}  // namespace

Material read_material(const JsonValue& value, std::size_t bands) {
  Material material;
  value.object({"name", "diffuse", "reflection", "transmission", "ior_by_band", "ior_minus_one_by_band", "camera_ior",
                "fresnel", "absorption_per_m", "emission", "roughness"});
  material.name = value.at("name").string();
  material.diffuse = read_texture(value.at("diffuse"), Range::share());
  material.reflection = value.at("reflection").colour(Range::share());
  material.transmission = value.at("transmission").colour(Range::share());
  material.ior_by_band = read_indices(value.at("ior_by_band"), bands, Range::positive());
  material.ior_minus_one_by_band =
      read_indices(value.at("ior_minus_one_by_band"), bands, {-1, Range::any().high, true});
  material.camera_ior = value.at("camera_ior").number(Range::positive());
  material.fresnel = value.at("fresnel").boolean();
  material.absorption_per_m = value.at("absorption_per_m").colour();
  material.emission = read_texture(value.at("emission"), Range::not_negative());
  material.roughness = read_roughness(value.at("roughness"));
  refuse_light_making(value, material);

  // n and n - 1 must tell the same story; the second one only has more digits. One part in 1e12 of n is far above
  // what printing loses and far below any difference that could be meant.
  for (std::size_t band = 0; band < bands && value.has("ior_by_band") && value.has("ior_minus_one_by_band"); ++band) {
    const double n = material.ior_by_band[band];
    if (!(std::abs(n - 1 - material.ior_minus_one_by_band[band]) <= 1e-12 * n))
      value.at("ior_minus_one_by_band").fault("differs from ior_by_band - 1", "write the same index in both");
  }
  return material;
}

}  // namespace vitrail
