// vitrail-tracer render: a lowered scene to an image and a run record.
#include <cstdio>
#include <optional>

#include "app/commands.h"
#include "base/cpu_clock.h"
#include "base/parallel.h"
#include "output/exr.h"
#include "output/progress.h"
#include "output/run_record.h"
#include "scene/read.h"

namespace vitrail {
namespace {

struct RenderOptions {
  std::string scene, image, views, record;
  unsigned threads = 0;
  std::optional<int> samples;
  std::optional<std::uint64_t> photons, seed;
  std::optional<double> gather_radius_m;
  bool progress = false;
};

void override_settings(const RenderOptions& options, Settings& settings) {
  settings.samples = options.samples.value_or(settings.samples);
  settings.photons = options.photons.value_or(settings.photons);
  settings.seed = options.seed.value_or(settings.seed);
  settings.gather_radius_m = options.gather_radius_m.value_or(settings.gather_radius_m);
}

void write_picture(const std::string& path, const Scene& scene, const Picture& picture, const Film& film,
                   unsigned threads) {
  std::map<std::string, std::string> metadata = {{"vitrail:scene_hash", scene.scene_hash},
                                                 {"vitrail:engine", "vitrail-tracer " VITRAIL_VERSION},
                                                 {"vitrail:settings", settings_json(scene, picture)}};
  if (!picture.view.empty()) metadata["vitrail:view"] = picture.view;
  write_exr(path, film, scene.plan, metadata, threads);
}

// The scene's own picture, and the views in their folder.
void write_pictures(const RenderOptions& options, const Scene& scene, const Rendering& rendering, unsigned threads) {
  write_picture(options.image, scene, scene.picture(), rendering.film, threads);
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    const Picture& view = scene.views[v];
    write_picture(options.views + "/" + view.view + ".exr", scene, view, rendering.views[v].film, threads);
  }
}

int run_render(const RenderOptions& options) {
  const double wall_start_s = wall_s();

  // Load, render, write.
  Scene scene = read_scene(options.scene);
  override_settings(options, scene.settings);
  if (options.views.empty()) scene.views.clear();
  ProgressLines progress(options.progress ? stderr : nullptr);
  const unsigned threads = thread_count(options.threads);
  const Rendering rendering = render(scene, {threads, progress});
  write_pictures(options, scene, rendering, threads);

  // Say what was done.
  for (const std::string& warning : rendering.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  if (!options.record.empty()) {
    const RunFacts facts{VITRAIL_VERSION, threads, process_cpu_s(), wall_s() - wall_start_s};
    write_text(options.record, run_record_json(scene, rendering, facts));
  }
  return rendering.interrupted ? kExitInterrupted : kExitOk;
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "render a lowered scene to an EXR image");
  command->add_option("scene", options->scene, "lowered scene, JSON")->required();
  command->add_option("--out", options->image, "image to write, EXR")->required();
  command->add_option("--views", options->views, "existing folder for the views of the scene, one EXR each")
      ->check(CLI::ExistingDirectory);
  command->add_option("--record", options->record, "run record to write, JSON");
  command->add_option("--threads", options->threads, "threads; 0 takes what the machine offers");
  command->add_option("--samples", options->samples, "samples per pixel of the scene's own picture")
      ->check(CLI::PositiveNumber);
  command->add_option("--photons", options->photons, "photons, shared out over lights and glass");
  command->add_option("--gather-radius-m", options->gather_radius_m, "radius of the gather disc in metres")
      ->check(CLI::PositiveNumber);
  command->add_option("--seed", options->seed, "another seed gives an independent picture");
  command->add_flag("--progress", options->progress, "write progress to stderr as JSON lines");
  command->callback([options, &exit_code] { exit_code = run_render(*options); });
}

}  // namespace vitrail
