#include "output/run_record.h"

#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "base/diagnostic.h"

namespace vitrail {
namespace {

using Json = nlohmann::ordered_json;

Json triplet(Rgb v) { return Json::array({v.r, v.g, v.b}); }

Json settings_object(const Scene& scene, const Picture& picture) {
  const Settings& settings = scene.settings;
  return {{"samples", picture.samples},
          {"photons", settings.photons},
          {"gather_radius_m", settings.gather_radius_m},
          {"seed", settings.seed},
          {"rough_samples", settings.rough_samples},
          {"final_gather_rays", settings.final_gather_rays},
          {"memory_limit_mb", settings.memory_limit_mb},
          {"solver", name_of(scene.solver())},
          {"branch_share", settings.branch_share},
          {"gather_disc", settings.gather_disc}};
}

Json ledger_object(const Ledger& ledger) {
  return {{"emitted", triplet(ledger.emitted)},     {"stored", triplet(ledger.stored)},
          {"absorbed", triplet(ledger.absorbed)},   {"escaped", triplet(ledger.escaped)},
          {"truncated", triplet(ledger.truncated)}, {"closure", ledger.closure()}};
}

// What limits cut, as shares of looks: in all, by limit and by layer, and the block of pixels that lost most. And the
// share of the light that came by weak branches, which other renderers drop.
Json camera_ledger_object(const CameraLedger& ledger, const Scene& scene) {
  Json limits = Json::object(), layers = Json::object();
  for (const Limit limit : {Limit::max_reflections, Limit::max_transmissions})
    limits[name_of(limit)] = ledger.cut(limit);
  for (int l = 0; l < kLayerCount; ++l) {
    const auto layer = static_cast<Layer>(l);
    if (ledger.cut(layer) > 0) layers[name_of(layer)] = ledger.cut(layer);
  }
  Json weak = Json::array();
  for (std::size_t i = 0; i < kWeakShares.size(); ++i)
    weak.push_back({{"below", kWeakShares[i]}, {"share", ledger.weak(i)}});
  Json record = {
      {"cut", ledger.cut()}, {"limits", limits}, {"layers", layers}, {"weak_branches", weak}, {"worst", nullptr}};
  const CameraLedger::Worst& worst = ledger.worst();
  if (!(worst.cut > 0)) return record;
  const PixelBlock& block = worst.block;
  record["worst"] = {{"cut", worst.cut},
                     {"x", {block.x0, block.x1 - 1}},
                     {"y", {block.y0, block.y1 - 1}},
                     {"limit", name_of(worst.limit)},
                     {"object", scene.objects[worst.object].name}};
  return record;
}

Json views_array(const Rendering& rendering, const Scene& scene) {
  Json views = Json::array();
  for (const RenderedView& view : rendering.views) {
    views.push_back({{"name", view.name},
                     {"camera_rays", view.camera_rays},
                     {"cpu_s", {{"camera", view.camera_cpu_s}, {"gather", view.gather_cpu_s}}},
                     {"camera_ledger", camera_ledger_object(view.camera_ledger, scene)}});
  }
  return views;
}

// What beams do not hold: the light that went on as photons, and an estimate of what their rays do not see.
Json beams_object(const BeamRemainder& remainder) {
  return {{"as_photons", triplet(remainder.as_photons)}, {"unseen", triplet(remainder.unseen)}};
}

// By which solver the light of each lamp goes through each object.
Json routes_array(const Scene& scene, const std::vector<LightRoute>& routes) {
  Json all = Json::array();
  for (const LightRoute& route : routes) {
    all.push_back({{"light", scene.lights[route.light].name},
                   {"object", scene.objects[route.target].name},
                   {"as", route.by_beams ? "beams" : "photons"},
                   {"torn", route.pilot.torn},
                   {"landings_per_ray", route.pilot.landings},
                   {"because", route.because}});
  }
  return all;
}

// The most that was resident, as the system counts it for this program alone: getrusage would count in what the program
// that started this one had resident at that moment.
std::uint64_t peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stoull(line.substr(6)) * 1024;  // Linux counts in kilobytes
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace

std::string settings_json(const Scene& scene, const Picture& picture) { return settings_object(scene, picture).dump(); }

std::string run_record_json(const Scene& scene, const Rendering& rendering, const RunFacts& facts) {
  const CpuSeconds& cpu = rendering.cpu_s;
  const Counters& counters = rendering.counters;
  Json settings = settings_object(scene, scene.picture());
  if (!rendering.routes.empty()) settings["solver"] = name_of(rendering.solver);
  const Json record = {{"vitrail_run", 1},
                       {"engine", "tracer"},
                       {"version", facts.version},
                       {"scene_hash", scene.scene_hash},
                       {"settings", settings},
                       {"threads", facts.threads},
                       {"cpu_s",
                        {{"total", facts.cpu_total_s},
                         {"build", cpu.build},
                         {"photon_pass", cpu.photon_pass},
                         {"photon_sort", cpu.photon_sort},
                         {"camera", cpu.camera},
                         {"gather", cpu.gather}}},
                       {"wall_s", facts.wall_s},
                       {"peak_memory_bytes", peak_memory_bytes()},
                       {"counters",
                        {{"camera_rays", counters.camera_rays},
                         {"shadow_rays", counters.shadow_rays},
                         {"photons_emitted", counters.photons_emitted},
                         {"photons_stored", counters.photons_stored},
                         {"gather_queries", counters.gather_queries}}},
                       {"views", views_array(rendering, scene)},
                       {"ledger", ledger_object(rendering.ledger)},
                       {"beams", beams_object(rendering.beam_remainder)},
                       {"light_routes", routes_array(scene, rendering.routes)},
                       {"camera_ledger", camera_ledger_object(rendering.camera_ledger, scene)},
                       {"warnings", rendering.warnings},
                       {"interrupted", rendering.interrupted}};
  return record.dump(2) + "\n";
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw OutputError({path, "cannot be written", "choose a folder that can be written"});
}

}  // namespace vitrail
