#pragma once
/// The global photon map: light that has been scattered by at least one diffuse surface on its way.

#include "base/workers.h"
#include "photon/photon_maps.h"
#include "photon/trace.h"

namespace vitrail {

/// Indirect light is smooth: its discs are this much wider than those of the caustic.
inline constexpr double kIndirectRadiusFactor = 4;

/// Emit settings.photons towards everything, half of them into each map, and let each walk: at every hit one lobe is
/// drawn with the probability of what it carries, so the walks keep their power and end when the light is absorbed.
/// Stored on every diffuse surface from the second one on [J96]; direct light and pure caustics are not in these maps.
/// No ledger. No maps if the monitor interrupts.
PhotonMaps make_indirect_maps(const World& world, const Workers& workers);

}  // namespace vitrail
