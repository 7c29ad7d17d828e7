#include "scene/read.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scene/centre.h"
#include "scene/read_parts.h"
#include "scene/validate.h"

namespace vitrail {

namespace {

Image read_image(const JsonValue& value) {
  value.object({"width", "height"});
  return {static_cast<int>(value.at("width").integer(1, 16384)),
          static_cast<int>(value.at("height").integer(1, 16384))};
}

int read_samples(const JsonValue& value) { return static_cast<int>(value.integer(1, 1 << 20)); }

Camera read_camera(const JsonValue& value) {
  Camera camera;
  value.object({"kind", "position", "forward", "right", "up", "half_width", "half_height"});
  camera.kind = value.at("kind").choice<CameraKind>(
      {{"perspective", CameraKind::perspective}, {"orthographic", CameraKind::orthographic}});
  camera.position = value.at("position").vector();
  camera.forward = value.at("forward").unit_vector();
  camera.right = value.at("right").unit_vector();
  camera.up = value.at("up").unit_vector();
  camera.half_width = value.at("half_width").number(Range::positive());
  camera.half_height = value.at("half_height").number(Range::positive());

  // Nine digits survive any printing; a mirrored or sheared camera is meant by nobody.
  const bool complete = value.has("forward") && value.has("right") && value.has("up");
  if (complete && !(length(cross(camera.forward, camera.up) - camera.right) <= 1e-9))
    value.fault("has axes that are not right = forward x up", "write an orthonormal, right-handed triple");
  return camera;
}

std::vector<Picture> read_views(const JsonValue& value) {
  std::vector<Picture> views;
  for (const JsonValue& item : value.array()) {
    item.object({"name", "image", "camera", "samples"});
    views.push_back({item.at("name").string(), read_image(item.at("image")), read_camera(item.at("camera")),
                     read_samples(item.at("samples"))});
  }
  return views;
}

std::vector<Band> read_bands(const JsonValue& value) {
  std::vector<Band> bands;
  for (const JsonValue& item : value.array()) {
    item.object({"name", "weight", "wavelength_nm"});
    Band band;
    band.name = item.at("name").string();
    band.weight = item.at("weight").colour(Range::any());  // continuous spectra have negative lobes
    if (!item.at("wavelength_nm").is_null()) band.wavelength_nm = item.at("wavelength_nm").number(Range::positive());
    bands.push_back(band);
  }
  if (bands.empty()) {
    value.fault("has no band", "write one band with weight [1, 1, 1]");
    bands.push_back({"all", {1, 1, 1}, {}});
  }
  return bands;
}

Transport read_transport(const JsonValue& value) {
  Transport transport;
  value.object({"indirect", "max_reflections", "max_transmissions"});
  const JsonValue indirect = value.at("indirect");
  if (indirect.is_object()) {
    indirect.object({"ambient"});
    transport.indirect = Indirect::ambient;
    transport.ambient = indirect.at("ambient").colour();
  } else {
    transport.indirect = indirect.choice<Indirect>({{"none", Indirect::none}, {"photons", Indirect::photons}});
  }
  transport.max_reflections = static_cast<int>(value.at("max_reflections").integer(0, 1000000));
  transport.max_transmissions = static_cast<int>(value.at("max_transmissions").integer(0, 1000000));
  return transport;
}

Paper read_paper(const JsonValue& value) {
  Paper paper;
  value.object(
      {"tir", "refraction", "literal_sum", "dispersion", "dispersion_reference", "disperse_camera", "rough_samples"},
      {"count_transmission", "shadow", "rough_photons"});
  paper.tir_drop = value.at("tir").choice<bool>({{"reflect", false}, {"drop", true}});
  paper.refraction_literal = value.at("refraction").choice<bool>({{"corrected", false}, {"literal", true}});
  paper.literal_sum = value.at("literal_sum").boolean();
  paper.dispersion_span = value.at("dispersion").choice<bool>({{"step", false}, {"span", true}});
  using Reference = Paper::DispersionReference;
  paper.dispersion_reference =
      value.at("dispersion_reference")
          .choice<Reference>({{"red", Reference::red}, {"d_line", Reference::d_line}, {"middle", Reference::middle}});
  paper.disperse_camera = value.at("disperse_camera").boolean();
  paper.rough_samples = static_cast<int>(value.at("rough_samples").integer(1, 1000000));
  paper.count_transmission = value.has("count_transmission") && value.at("count_transmission").boolean();
  paper.shadow_filter = value.has("shadow") && value.at("shadow").choice<bool>({{"opaque", false}, {"filter", true}});
  paper.rough_photons_literal =
      value.has("rough_photons") && value.at("rough_photons").choice<bool>({{"reciprocal", false}, {"literal", true}});
  return paper;
}

Plan read_plan(const JsonValue& value) {
  value.object({"diffusion", "reflection", "refraction", "total_internal_reflection", "coloured_transmission",
                "absorption", "caustic", "roughness", "dispersion", "shadow", "indirect_light"});
  const auto on = [&](const char* phenomenon) { return value.at(phenomenon).boolean(); };
  return {.diffusion = on("diffusion"),
          .reflection = on("reflection"),
          .refraction = on("refraction"),
          .total_internal_reflection = on("total_internal_reflection"),
          .coloured_transmission = on("coloured_transmission"),
          .absorption = on("absorption"),
          .caustic = on("caustic"),
          .roughness = on("roughness"),
          .dispersion = on("dispersion"),
          .shadow = on("shadow"),
          .indirect_light = on("indirect_light")};
}

Settings read_settings(const JsonValue& value) {
  Settings settings;
  value.object({"samples", "photons", "gather_radius_m", "seed", "rough_samples", "final_gather_rays",
                "memory_limit_mb", "solver"},
               {"branch_share", "gather_disc"});
  settings.samples = read_samples(value.at("samples"));
  settings.photons = static_cast<std::uint64_t>(value.at("photons").integer(0, std::int64_t{1} << 40));
  settings.gather_radius_m = value.at("gather_radius_m").number(Range::not_negative());
  settings.seed = value.at("seed").count();
  settings.rough_samples = static_cast<int>(value.at("rough_samples").integer(0, 1000000));
  settings.final_gather_rays = static_cast<int>(value.at("final_gather_rays").integer(0, 1000000));
  const JsonValue memory = value.at("memory_limit_mb");
  settings.memory_limit_mb = memory.is_null() ? 0 : memory.number(Range::not_negative());
  settings.solver = value.at("solver").choice<Solver>({{"auto", Solver::automatic},
                                                       {"photon_map", Solver::photon_map},
                                                       {"light_bins", Solver::light_bins},
                                                       {"beams", Solver::beams}});
  if (value.has("branch_share")) settings.branch_share = value.at("branch_share").number(Range::share());
  settings.gather_disc = value.has("gather_disc") && value.at("gather_disc").boolean();
  return settings;
}

Object read_object(const JsonValue& value, std::size_t materials) {
  Object object;
  value.object({"name", "material", "priority", "shape"});
  object.name = value.at("name").string();
  const auto last = static_cast<std::int64_t>(materials) - 1;
  object.material = static_cast<std::uint32_t>(value.at("material").integer(0, last < 0 ? 0 : last));
  object.priority = static_cast<int>(value.at("priority").integer(-1000000, 1000000));
  object.shape = read_shape(value.at("shape"));
  return object;
}

Scene read_parts(const JsonValue& root) {
  Scene scene;
  root.object({"vitrail_lowered", "title", "scene_hash", "image", "camera", "bands", "materials", "objects", "lights",
               "transport", "paper", "plan", "settings"},
              {"views"});
  root.at("vitrail_lowered").integer(1, 1);
  scene.title = root.at("title").string();
  scene.scene_hash = root.at("scene_hash").string();
  scene.image = read_image(root.at("image"));
  scene.camera = read_camera(root.at("camera"));
  if (root.has("views")) scene.views = read_views(root.at("views"));
  scene.bands = read_bands(root.at("bands"));
  for (const JsonValue& item : root.at("materials").array())
    scene.materials.push_back(read_material(item, scene.bands.size()));
  for (const JsonValue& item : root.at("objects").array())
    scene.objects.push_back(read_object(item, scene.materials.size()));
  for (const JsonValue& item : root.at("lights").array()) scene.lights.push_back(read_light(item));
  scene.transport = read_transport(root.at("transport"));
  scene.paper = read_paper(root.at("paper"));
  scene.plan = read_plan(root.at("plan"));
  scene.settings = read_settings(root.at("settings"));
  return scene;
}

}  // namespace

Scene parse_scene(const std::string& text) {
  nlohmann::json document;
  try {
    document = nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw InputError({{"scene", std::string("is not JSON: ") + error.what(), "write a lowered scene"}});
  }

  // Collect all faults of form first; the rules between parts make sense only for well-formed parts.
  Faults faults;
  if (!document.is_object()) throw InputError({{"scene", "is not an object", "write a lowered scene"}});
  Scene scene = read_parts(JsonValue(document, "scene", faults));
  if (faults.empty()) faults = validate(scene);
  if (!faults.empty()) throw InputError(faults);
  return scene;
}

Scene read_scene(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()))
    throw InputError({{path, "cannot be read", "name an existing, readable file with a lowered scene"}});
  Scene scene = parse_scene(text.str());
  centre_scene(scene);
  return scene;
}

}  // namespace vitrail
