#pragma once
/// The pass that makes caustics: light from the lamps by way of mirrors and glass to diffuse surfaces.

#include "base/workers.h"
#include "photon/photon_maps.h"
#include "photon/trace.h"

namespace vitrail {

/// Emit settings.photons, half of them into each map. With the solver `beams`, light from places and directions through
/// smooth faces goes into beams, the rest into photons. No maps if the monitor interrupts.
PhotonMaps make_caustic_maps(const World& world, const Workers& workers);

/// How often a photon is stored, from a few hundred of every chart. Faces that divide light make this more than 1.
double stored_per_photon(const World& world);

/// Peak bytes of the pass if each photon is stored so many times.
std::uint64_t predicted_photon_bytes(std::uint64_t photons, double stored_per_photon);

}  // namespace vitrail
