#include "render/render.h"

#include <cstdio>
#include <optional>

#include "base/cpu_clock.h"
#include "base/diagnostic.h"
#include "base/parallel.h"
#include "render/beam_bins.h"
#include "render/light_bins.h"
#include "render/tile.h"

namespace vitrail {
namespace {

// Of the photons' light: the error in light that closed forms are held to.
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
// between two rays of a lattice that part, which no beam holds.
void warn_of_truncated_light(const Scene& scene, const PhotonStatistics& statistics,
                             std::vector<std::string>& warnings) {
  const Ledger& ledger = statistics.ledger;
  if (const auto share = lost_share(ledger, ledger.truncated - statistics.at_discontinuities)) {
    warnings.push_back(*share + " of the photons' light was cut after " +
                       std::to_string(scene.transport.max_reflections) + " reflections or " +
                       std::to_string(scene.transport.max_transmissions) +
                       " transmissions; raise transport.max_reflections or max_transmissions");
  }
  if (const auto share = lost_share(ledger, statistics.at_discontinuities)) {
    warnings.push_back(*share + " of the photons' light fell between beams, where rays part; raise photons");
  }
}

void add(const Scene& scene, const PhotonStatistics& statistics, Rendering& result) {
  result.ledger = statistics.ledger;
  result.warnings.insert(result.warnings.end(), statistics.warnings.begin(), statistics.warnings.end());
  warn_of_truncated_light(scene, statistics, result.warnings);
  result.cpu_s.photon_pass += statistics.trace_cpu_s;
  result.cpu_s.photon_sort += statistics.sort_cpu_s;
  result.counters.photons_emitted += statistics.emitted;
  result.counters.photons_stored += statistics.stored;
}

void add(const IndirectMaps& maps, Rendering& result) {
  result.warnings.insert(result.warnings.end(), maps.warnings.begin(), maps.warnings.end());
  result.cpu_s.photon_pass += maps.trace_cpu_s;
  result.cpu_s.photon_sort += maps.sort_cpu_s;
  result.counters.photons_emitted += maps.emitted;
  result.counters.photons_stored += maps.stored;
}

void count_in_pixels(const Scene& scene, const Intersector& intersector, const PhotonMaps& maps, unsigned threads,
                     Monitor& monitor, Rendering& result) {
  for (int half = 0; half < 2; ++half) {
    if (maps.half[half]) {
      result.cpu_s.gather +=
          deposit_in_pixels(scene, intersector, *maps.half[half], half, threads, monitor, result.film);
    }
    if (maps.beams[half]) {
      result.cpu_s.gather += deposit_beams(scene, intersector, *maps.beams[half], half, threads, monitor, result.film);
    }
  }
}

void refuse_what_cannot_work(const Scene& scene, const Intersector& intersector) {
  std::vector<Diagnostic> found;
  if ((has_photon_pass(scene) || has_indirect_pass(scene)) && !(scene.settings.gather_radius_m > 0)) {
    found.push_back({"settings.gather_radius_m", "is not above 0, but the plan has a photon pass",
                     "give the radius of the gather disc in metres"});
  }
  if (scene.settings.photons / 2 >= (std::uint64_t{1} << 32)) {
    found.push_back({"settings.photons", "is above 2^33", "render several seeds and average them"});
  }
  const std::string& solver = scene.settings.solver;
  if (solver != "auto" && solver != "photon_map" && solver != "light_bins" && solver != "beams") {
    found.push_back({"settings.solver", "is `" + solver + "`", "write auto, photon_map, light_bins or beams"});
  }
  const double mb = static_cast<double>(predicted_bytes(scene, intersector)) / 1e6;
  if (scene.settings.memory_limit_mb > 0 && mb > scene.settings.memory_limit_mb) {
    found.push_back({"settings.memory_limit_mb",
                     "the rendering needs about " + std::to_string(static_cast<long>(mb)) + " MB, the limit is " +
                         std::to_string(static_cast<long>(scene.settings.memory_limit_mb)) + " MB",
                     "lower `photons` or the image size, or raise the limit"});
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

Rendering render(const Scene& scene, unsigned threads, Monitor& monitor) {
  // Build what rays ask, and see whether the rest fits.
  const double start = thread_cpu_s();
  const Intersector intersector(scene);
  refuse_what_cannot_work(scene, intersector);
  Rendering result{Film(scene.image.width, scene.image.height), {}, {}, {}, {}, false};
  result.cpu_s.build = thread_cpu_s() - start;

  // Send out the photons.
  LightMaps maps;
  if (has_photon_pass(scene)) {
    maps.caustic = make_photon_maps(scene, intersector, threads, monitor);
    add(scene, maps.caustic.statistics, result);
  }
  if (has_indirect_pass(scene)) {
    maps.indirect = make_indirect_maps(scene, intersector, threads, monitor);
    add(maps.indirect, result);
  }

  // Look through every pixel.
  const std::vector<Tile> tiles = tiles_of(scene.image);
  std::vector<TileStatistics> statistics(tiles.size());
  const TileContext context{scene, intersector, maps};
  monitor.begin("camera", tiles.size());
  parallel_blocks(tiles.size(), threads, [&](std::uint64_t t, unsigned) {
    if (monitor.interrupted()) return;
    statistics[t] = render_tile(context, tiles[t], result.film);
    monitor.advance(1);
  });
  for (const TileStatistics& tile : statistics) {
    result.counters += tile.counters;
    result.cpu_s.camera += tile.camera_cpu_s;
    result.cpu_s.gather += tile.gather_cpu_s;
  }
  if (counts_in_pixels(scene)) count_in_pixels(scene, intersector, maps.caustic, threads, monitor, result);
  result.interrupted = monitor.interrupted();
  return result;
}

std::string solver_of(const Scene& scene) {
  if (takes_beams(scene)) return "beams";
  return takes_light_bins(scene) ? "light_bins" : "photon_map";
}

std::uint64_t predicted_bytes(const Scene& scene, const Intersector& intersector) {
  std::uint64_t bytes = Film::predicted_bytes(scene.image.width, scene.image.height);
  if (has_photon_pass(scene)) {
    const double stored = stored_per_photon(scene, intersector);
    const auto corners = static_cast<std::size_t>(stored * static_cast<double>(scene.settings.photons));
    bytes +=
        takes_beams(scene) ? BeamMap::predicted_bytes(corners) : predicted_photon_bytes(scene.settings.photons, stored);
  }
  // A walk in a white room stores a photon several times; in most rooms fewer than three.
  if (has_indirect_pass(scene)) bytes += predicted_photon_bytes(scene.settings.photons, 3);
  return bytes;
}

}  // namespace vitrail
