#include "render/render.h"

#include <cstdio>
#include <optional>

#include "base/cpu_clock.h"
#include "base/diagnostic.h"
#include "photon/caustic_pass.h"
#include "photon/indirect_pass.h"
#include "render/beam_bins.h"
#include "render/light_bins.h"
#include "render/pixel_sums.h"
#include "render/tile.h"

namespace vitrail {
namespace {

// Of the photons' light, or of what the camera sees: the error in light that closed forms are held to.
constexpr double kTruncatedShare = 0.005;

bool has_photon_pass(const Scene& scene) { return scene.plan.caustic && scene.settings.photons > 0; }

bool has_indirect_pass(const Scene& scene) {
  return scene.transport.indirect == Indirect::photons && scene.plan.indirect_light && scene.settings.photons > 0;
}

// The share of the photons' light in percent, where it is worth a warning.
std::optional<std::string> lost_share(const Ledger& ledger, Rgb lost) {
  const double emitted = largest_channel(ledger.emitted), cut = largest_channel(lost);
  if (!(cut > kTruncatedShare * emitted)) return {};
  char share[16];
  std::snprintf(share, sizeof share, "%.2g %%", 100 * cut / emitted);
  return share;
}

// Light that was still on its way when the limits of the scene ended it: the other engine may let it go on. And light
// that takes other ways between the rays of a lattice than at them.
void warn_of_truncated_light(const Scene& scene, const PhotonStatistics& statistics,
                             std::vector<std::string>& warnings) {
  const Ledger& ledger = statistics.ledger;
  if (const auto share = lost_share(ledger, ledger.truncated)) {
    warnings.push_back(*share + " of the photons' light was cut after " +
                       std::to_string(scene.transport.max_reflections) + " reflections or " +
                       std::to_string(scene.transport.max_transmissions) +
                       " transmissions; raise transport.max_reflections or max_transmissions");
  }
  if (const auto share = lost_share(ledger, statistics.remainder.unseen)) {
    warnings.push_back(
        *share +
        " of the photons' light takes ways between the rays of beams that these do not see; raise photons, or take the "
        "solver light_bins");
  }
}

// Add the costs and warnings of a photon pass.
void add(const PhotonStatistics& statistics, Rendering& result) {
  result.warnings.insert(result.warnings.end(), statistics.warnings.begin(), statistics.warnings.end());
  result.cpu_s.photon_pass += statistics.trace_cpu_s;
  result.cpu_s.photon_sort += statistics.sort_cpu_s;
  result.counters.photons_emitted += statistics.emitted;
  result.counters.photons_stored += statistics.stored;
}

// Send out the photons.
LightMaps trace_light(const World& world, const Workers& workers, Rendering& result) {
  LightMaps maps;
  if (has_photon_pass(world.scene)) {
    maps.caustic = make_caustic_maps(world, workers);
    const PhotonStatistics& statistics = maps.caustic.statistics;
    result.ledger = statistics.ledger;
    result.beam_remainder = statistics.remainder;
    result.routes = statistics.routes;
    result.solver = statistics.solver;
    add(statistics, result);
    warn_of_truncated_light(world.scene, statistics, result.warnings);
  }
  if (has_indirect_pass(world.scene)) {
    maps.indirect = make_indirect_maps(world, workers);
    add(maps.indirect.statistics, result);
  }
  return maps;
}

// A picture under way: what it shows, where its light is collected, and what it has cost.
struct Canvas {
  Picture picture;
  Film& film;
  TileStatistics cost{};
};

// The scene's own picture and its views, in this order.
std::vector<Canvas> canvases_of(const Scene& scene, Rendering& result) {
  for (const Picture& view : scene.views) {
    result.views.push_back({.name = view.view, .film = Film(view.image.width, view.image.height)});
  }
  std::vector<Canvas> canvases{{scene.picture(), result.film}};
  for (std::size_t v = 0; v < scene.views.size(); ++v) canvases.push_back({scene.views[v], result.views[v].film});
  return canvases;
}

// Follow the camera paths of every pixel of every picture.
void trace_camera(const LitWorld& world, const Workers& workers, std::vector<Canvas>& canvases) {
  struct TileOf {
    Canvas* canvas;
    Tile tile;
  };
  std::vector<TileOf> tiles;
  for (Canvas& canvas : canvases) {
    for (const Tile& tile : tiles_of(canvas.picture.image)) tiles.push_back({&canvas, tile});
  }
  std::vector<TileStatistics> statistics(tiles.size());
  workers.monitor.begin("camera", tiles.size());
  workers.for_each_block(tiles.size(), [&](std::uint64_t t) {
    const Canvas& canvas = *tiles[t].canvas;
    statistics[t] = render_tile(world, canvas.picture, tiles[t].tile, canvas.film);
  });
  for (std::size_t t = 0; t < tiles.size(); ++t) tiles[t].canvas->cost += statistics[t];
}

// Count the light of the maps in the pixels of every picture.
void count_in_pixels(const World& world, const PhotonMaps& maps, const Workers& workers,
                     std::vector<Canvas>& canvases) {
  std::uint64_t blocks = 0;
  for (int half = 0; half < 2; ++half) {
    if (maps.half[half]) blocks += deposit_blocks(*maps.half[half]);
    if (maps.beams[half]) blocks += deposit_blocks(*maps.beams[half]);
  }
  workers.monitor.begin("light_bins", blocks * canvases.size());
  for (auto& [picture, film, cost] : canvases) {
    for (int half = 0; half < 2; ++half) {
      if (maps.half[half])
        cost.gather_cpu_s += deposit_in_pixels(world, picture, *maps.half[half], half, workers, film);
      if (maps.beams[half]) cost.gather_cpu_s += deposit_beams(world, picture, *maps.beams[half], half, workers, film);
    }
  }
}

// Keep what the limits of the scene cut from the looks of a picture, and warn of it.
void book_cuts(const Canvas& canvas, const Scene& scene, CameraLedger& ledger, std::vector<std::string>& warnings) {
  ledger = canvas.cost.ledger;
  const std::string warning = warning_of(ledger, scene, kTruncatedShare);
  if (warning.empty()) return;
  const std::string& view = canvas.picture.view;
  warnings.push_back(view.empty() ? warning : "view `" + view + "`: " + warning);
}

// Add up what the pictures cost, and note it with each view.
void add_costs(const std::vector<Canvas>& canvases, Rendering& result) {
  for (const Canvas& canvas : canvases) {
    result.counters += canvas.cost.counters;
    result.cpu_s.camera += canvas.cost.camera_cpu_s;
    result.cpu_s.gather += canvas.cost.gather_cpu_s;
  }
  for (std::size_t v = 0; v < result.views.size(); ++v) {
    const TileStatistics& cost = canvases[v + 1].cost;
    result.views[v].camera_rays = cost.counters.camera_rays;
    result.views[v].camera_cpu_s = cost.camera_cpu_s;
    result.views[v].gather_cpu_s = cost.gather_cpu_s;
  }
}

std::uint64_t film_bytes(const Scene& scene, const Image& image) {
  const bool has_sums = has_photon_pass(scene) && scene.solver() != Solver::photon_map && !scene.settings.gather_disc;
  return Film::predicted_bytes(image.width, image.height, planned_layers(scene.plan)) +
         (has_sums ? PixelSums::predicted_bytes(image.width, image.height) : 0);
}

void refuse_what_cannot_work(const World& world) {
  const Scene& scene = world.scene;
  std::vector<Diagnostic> found;
  if ((has_photon_pass(scene) || has_indirect_pass(scene)) && !(scene.settings.gather_radius_m > 0)) {
    found.push_back({"settings.gather_radius_m", "is not above 0, but the plan has a photon pass",
                     "give the radius of the gather disc in metres"});
  }
  if (scene.settings.photons / 2 >= (std::uint64_t{1} << 32)) {
    found.push_back({"settings.photons", "is above 2^33", "render several seeds and average them"});
  }
  const double mb = static_cast<double>(predicted_bytes(world)) / 1e6;
  if (scene.settings.memory_limit_mb > 0 && mb > scene.settings.memory_limit_mb) {
    found.push_back({"settings.memory_limit_mb",
                     "the rendering needs about " + std::to_string(static_cast<long>(mb)) + " MB, the limit is " +
                         std::to_string(static_cast<long>(scene.settings.memory_limit_mb)) + " MB",
                     "lower `photons` or the size of the pictures, or raise the limit"});
  }
  if (!found.empty()) throw InputError(found);
}

}  // namespace

Counters& Counters::operator+=(const Counters& other) {
  camera_rays += other.camera_rays;
  shadow_rays += other.shadow_rays;
  photons_emitted += other.photons_emitted;
  photons_stored += other.photons_stored;
  gather_queries += other.gather_queries;
  return *this;
}

Rendering render(const Scene& scene, const Workers& workers) {
  // Build what rays ask, and see whether the rest fits.
  const double start = thread_cpu_s();
  const Intersector intersector(scene);
  const World world{scene, intersector};
  refuse_what_cannot_work(world);
  Rendering result{.film = Film(scene.image.width, scene.image.height)};
  result.cpu_s.build = thread_cpu_s() - start;

  // Send out the photons, follow the camera paths, and bring the two together.
  const LightMaps maps = trace_light(world, workers, result);
  std::vector<Canvas> canvases = canvases_of(scene, result);
  trace_camera({world, maps}, workers, canvases);
  if (counts_in_pixels(scene, maps.caustic)) count_in_pixels(world, maps.caustic, workers, canvases);
  add_costs(canvases, result);
  book_cuts(canvases[0], scene, result.camera_ledger, result.warnings);
  for (std::size_t v = 0; v < result.views.size(); ++v)
    book_cuts(canvases[v + 1], scene, result.views[v].camera_ledger, result.warnings);
  result.interrupted = workers.monitor.interrupted();
  return result;
}

std::uint64_t predicted_bytes(const World& world) {
  const Scene& scene = world.scene;
  std::uint64_t bytes = film_bytes(scene, scene.image);
  for (const Picture& view : scene.views) bytes += film_bytes(scene, view.image);
  if (has_photon_pass(scene)) {
    const double stored = stored_per_photon(world);
    const auto corners = static_cast<std::size_t>(stored * static_cast<double>(scene.settings.photons));
    bytes += scene.solver() == Solver::beams ? BeamMap::predicted_bytes(corners)
                                             : predicted_photon_bytes(scene.settings.photons, stored);
  }
  // A walk in a white room stores a photon several times; in most rooms fewer than three.
  if (has_indirect_pass(scene)) bytes += predicted_photon_bytes(scene.settings.photons, 3);
  return bytes;
}

}  // namespace vitrail
