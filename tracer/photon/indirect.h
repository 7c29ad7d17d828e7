#pragma once
/// The global photon map: light that has been scattered by at least one diffuse surface on its way.

#include <memory>

#include "base/monitor.h"
#include "photon/trace.h"

namespace vitrail {

/// Indirect light is smooth: its discs are this much wider than those of the caustic.
inline constexpr double kIndirectRadiusFactor = 4;

struct IndirectMaps {
  std::unique_ptr<PhotonMap> half[2];
  std::uint64_t emitted = 0, stored = 0;
  double trace_cpu_s = 0, sort_cpu_s = 0;
  std::vector<std::string> warnings;
};

/// Emit settings.photons towards everything, half of them into each map, and let each walk: at every hit one way on is
/// drawn with the probability of what it carries, so the walks keep their power and end when the light is absorbed.
/// Stored on every diffuse surface from the second one on [J96]; direct light and pure caustics are not in these maps.
IndirectMaps make_indirect_maps(const Scene& scene, const Intersector& intersector, unsigned threads, Monitor& monitor);

}  // namespace vitrail
