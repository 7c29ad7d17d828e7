#include "scene/solver.h"

#include <algorithm>
#include <stdexcept>

#include "scene/scene.h"

namespace vitrail {

const char* name_of(Solver solver) {
  switch (solver) {
    case Solver::automatic:
      return "auto";
    case Solver::photon_map:
      return "photon_map";
    case Solver::light_bins:
      return "light_bins";
    case Solver::beams:
      return "beams";
  }
  throw std::logic_error("no such solver");
}

Solver resolve(Solver asked, const SolverFacts& facts) {
  if (asked != Solver::automatic) return asked;
  if (facts.rays_alone) return Solver::beams;
  return facts.photons_per_pixel >= kPhotonsForBins ? Solver::light_bins : Solver::photon_map;
}

namespace {

bool sends_rays_alone(const Light& light) {
  if (const auto* sun = std::get_if<DirectionalLight>(&light.emitter)) return sun->angular_diameter_deg == 0;
  if (const auto* lamp = std::get_if<AreaLight>(&light.emitter)) return lamp->collimated;
  return !std::holds_alternative<EnvironmentLight>(light.emitter);
}

double photons_per_pixel(const Scene& scene) {
  return static_cast<double>(scene.settings.photons) / (static_cast<double>(scene.image.width) * scene.image.height);
}

}  // namespace

Solver Scene::solver() const {
  const bool rays_alone = !plan.roughness && std::any_of(lights.begin(), lights.end(), sends_rays_alone);
  return resolve(settings.solver, {rays_alone, photons_per_pixel(*this)});
}

Solver Scene::solver_without_beams() const { return resolve(settings.solver, {false, photons_per_pixel(*this)}); }

}  // namespace vitrail
