#pragma once
/// A scene to films: photons first, once for all pictures, then every picture tile by tile.

#include <string>
#include <vector>

#include "base/workers.h"
#include "geometry/world.h"
#include "photon/photon_maps.h"
#include "render/camera_ledger.h"
#include "render/film.h"

namespace vitrail {

/// CPU seconds of all threads by phase.
struct CpuSeconds {
  double build = 0, photon_pass = 0, photon_sort = 0, camera = 0, gather = 0;
};

struct Counters {
  std::uint64_t camera_rays = 0, shadow_rays = 0, photons_emitted = 0, photons_stored = 0, gather_queries = 0;
  Counters& operator+=(const Counters& other);
};

/// A picture more, its film and what it cost.
struct RenderedView {
  std::string name;
  Film film;
  CameraLedger camera_ledger{};
  std::uint64_t camera_rays = 0;
  double camera_cpu_s = 0, gather_cpu_s = 0;
};

/// Costs and counters are those of all pictures together.
struct Rendering {
  Film film;  // of the scene's own picture
  std::vector<RenderedView> views{};
  Ledger ledger{};
  BeamRemainder beam_remainder{};
  std::vector<LightRoute> routes{};
  Solver solver = Solver::photon_map;  // of caustics
  CameraLedger camera_ledger{};        // of the scene's own picture
  CpuSeconds cpu_s{};
  Counters counters{};
  std::vector<std::string> warnings{};
  bool interrupted = false;
};

/// Render the scene's picture and its views from the same photons. The same bits for any number of threads; views
/// change nothing in the picture. Throws InputError if settings cannot work: no
/// gather radius for a caustic, or more memory predicted than settings.memory_limit_mb.
Rendering render(const Scene& scene, const Workers& workers);

/// Peak bytes of a rendering, before they are allocated.
std::uint64_t predicted_bytes(const World& world);

}  // namespace vitrail
