#include "photon/caustic_pass.h"

#include <algorithm>
#include <cmath>

#include "photon/beams/beam_pass.h"
#include "photon/halves.h"

namespace vitrail {
namespace {

PhotonPass pass_of(const World& world, const Targets& targets) {
  return {world, {targets.surroundings.center}, targets.surroundings.radius};
}

// Trace the photons of all charts, and sort those of each half into a map, after those that are there already.
void make_photons(const PhotonPass& pass, const std::vector<Chart>& charts, const Workers& workers, PhotonMaps& maps,
                  PhotonBlocks photons) {
  const Settings& settings = pass.scene.settings;
  auto traced = trace_halves(plan_blocks(charts), "photon_pass", workers, [&](const ChartBlock& block) {
    const Stream stream = stream_of(settings.seed, Purpose::kEmissionPosition, block.chart, block.half);
    return trace_photons(pass, charts[block.chart], stream, block.first, block.count);
  });

  // Add the ledgers in the order of the blocks.
  PhotonStatistics& statistics = maps.statistics;
  for (std::size_t half = 0; half < 2; ++half) {
    for (PhotonBlock& block : traced.half[half]) {
      statistics.ledger += block.ledger;
      statistics.stored += block.photons.size();
      photons[half].push_back(std::move(block.photons));
    }
  }
  for (const Chart& chart : charts) statistics.emitted += 2 * chart.count;
  statistics.trace_cpu_s += traced.cpu_s;
  statistics.sort_cpu_s += build_halves(workers, [&](std::uint64_t half) {
    maps.half[half] = std::make_unique<PhotonMap>(pass.frame, std::move(photons[half]), settings.gather_radius_m);
  });
}

// Where more of the light than this is between rays that part, beams cost more than photons and have their noise.
constexpr double kMostTorn = 0.25;

// A ray of a lattice costs about as much as ten photons, and is worth as many: `auto` takes that many fewer.
constexpr double kPhotonsPerRay = 10;

// Where a ray lands more often than this, per band, its light is in ever wider sheets: dear to paint, and to look at
// through glass. `auto` leaves them to photons. Of balls, panes, prisms and mirrors all with 1 to 1.2 are better off
// with beams, by 2 to 25 in CPU seconds at equal noise, and those with 1.6 to 4.3 worse off, by 1.3 to 3.5.
constexpr double kMostLandings = 1.5;

// A pilot ends early where its rays land so many times more often: rays through thick glass have hundreds of branches.
constexpr double kFarBeyond = 3;

// The rays of a chart if it goes as beams.
Chart as_rays(const Settings& settings, Chart chart) {
  if (settings.solver == Solver::automatic) {
    chart.count = static_cast<std::uint64_t>(std::ceil(static_cast<double>(chart.count) / kPhotonsPerRay));
  }
  return chart;
}

// Whether the light of a chart goes as beams.
LightRoute route_of(const PhotonPass& pass, const Chart& chart) {
  const Settings& settings = pass.scene.settings;
  LightRoute route{chart.light, chart.target, false, {}, nullptr};
  if (pass.scene.solver() != Solver::beams) {
    route.because = "the solver takes photons";
  } else if (const char* unfit = unfit_for_beams(pass.scene, chart)) {
    route.because = unfit;
  } else {
    const Chart rays = as_rays(settings, chart);
    const auto bands = static_cast<double>(pass.scene.bands.size());
    const bool counts_landings = settings.solver == Solver::automatic;
    const auto is_far_beyond = [&](const BeamPilot& pilot) {
      return counts_landings && pilot.landings > kFarBeyond * kMostLandings * bands;
    };
    route.pilot = BeamLattice(pass, rays, stream_of(settings.seed, Purpose::kPilot)).pilot(is_far_beyond);
    const bool torn = route.pilot.torn > kMostTorn;
    const bool dear = counts_landings && route.pilot.landings > kMostLandings * bands;
    route.by_beams = !torn && !dear;
    route.because = torn   ? "its rays part"
                    : dear ? "its rays divide too often"
                           : "from each place of the light one ray, through smooth faces";
  }
  return route;
}

}  // namespace

PhotonMaps make_caustic_maps(const World& world, const Workers& workers) {
  const Scene& scene = world.scene;
  const Targets targets = find_targets(scene, world.intersector);
  const PhotonPass pass = pass_of(world, targets);

  // Leave to beams what they can do.
  PhotonMaps maps;
  maps.statistics.warnings = targets.warnings;
  std::vector<Chart> photons, beams;
  for (const Chart& chart : make_charts(scene, targets, scene.settings.photons / 2)) {
    const LightRoute route = route_of(pass, chart);
    maps.statistics.routes.push_back(route);
    route.by_beams ? beams.push_back(as_rays(scene.settings, chart)) : photons.push_back(chart);
  }

  maps.statistics.solver = beams.empty() ? scene.solver_without_beams() : scene.solver();

  PhotonBlocks between_beams;
  if (!beams.empty()) make_beams(pass, beams, workers, maps, between_beams);
  make_photons(pass, photons, workers, maps, std::move(between_beams));
  maps.statistics.ledger = maps.statistics.ledger.scaled(0.5);
  return maps;
}

double stored_per_photon(const World& world) {
  constexpr std::uint64_t kPilot = 512;
  const Scene& scene = world.scene;
  const Targets targets = find_targets(scene, world.intersector);
  const PhotonPass pass = pass_of(world, targets);
  double stored = 0, emitted = 0;
  for (const Chart& chart : make_charts(scene, targets, scene.settings.photons / 2)) {
    const std::uint64_t count = std::min(kPilot, chart.count);
    const Stream stream = stream_of(scene.settings.seed, Purpose::kPilot);
    const PhotonBlock block = trace_photons(pass, chart, stream, 0, count);
    const double each_stands_for = static_cast<double>(chart.count) / static_cast<double>(count);
    stored += each_stands_for * static_cast<double>(block.photons.size());
    emitted += static_cast<double>(chart.count);
  }
  return emitted > 0 ? stored / emitted : 0;
}

std::uint64_t predicted_photon_bytes(std::uint64_t photons, double stored_per_photon) {
  const auto stored = static_cast<std::uint64_t>(stored_per_photon * static_cast<double>(photons));
  return 2 * PhotonMap::predicted_bytes(stored / 2);
}

}  // namespace vitrail
