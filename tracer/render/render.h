#pragma once
/// A scene to a film: photons first, then the image tile by tile.

#include <string>
#include <vector>

#include "base/workers.h"
#include "geometry/world.h"
#include "photon/ledger.h"
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

struct Rendering {
  Film film;
  Ledger ledger{};
  CpuSeconds cpu_s{};
  Counters counters{};
  std::vector<std::string> warnings{};
  bool interrupted = false;
};

/// Render with scene.settings. The same bits for any number of threads. Throws InputError if settings cannot work: no
/// gather radius for a caustic, or more memory predicted than settings.memory_limit_mb.
Rendering render(const Scene& scene, const Workers& workers);

/// Peak bytes of a rendering, before they are allocated.
std::uint64_t predicted_bytes(const World& world);

}  // namespace vitrail
