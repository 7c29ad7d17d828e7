#include "photon/photon_tree.h"

#include <algorithm>

#include "material/roughen.h"

namespace vitrail {

bool tells_bands_apart(const Scene& scene, std::uint32_t object) {
  if (object == kAir || scene.bands.size() < 2) return false;
  const auto& ior = scene.material_of(object).ior_by_band;
  return std::any_of(ior.begin(), ior.end(), [&](double n) { return n != ior[0]; });
}

void PhotonTree::follow(const Flight& start) {
  pending_.clear();
  pending_.push_back(start);
  while (!pending_.empty()) {
    const Flight flight = pending_.back();
    pending_.pop_back();
    const Arrival arrival =
        advance(scene_, pass_.intersector, flight.ray, flight.departures, flight.media, flight.band);
    if (!flight.has_bounced()) {
      // Leave photons that meet another object to its own chart, or to direct light.
      if (arrival.escaped || arrival.event.object != target_) return;
      ledger_.emitted += flight.flux;
    }
    arrive(flight, arrival);
  }
}

void PhotonTree::arrive(const Flight& flight, const Arrival& arrival) {
  const Rgb flux = flight.flux * arrival.transmittance;
  ledger_.absorbed += flight.flux - flux;
  if (arrival.escaped) {
    ledger_.escaped += flux;
    return;
  }
  const Interaction& event = arrival.event;
  const bool splits = !flight.band_chosen && event.transmit.exists &&
                      (tells_bands_apart(scene_, event.medium_before) || tells_bands_apart(scene_, event.medium_after));
  if (splits) {
    split_bands(flight, arrival, flux);
  } else {
    go_on(flight, arrival, event, flux);
  }
}

// Give each band its weight of the flux; from here on it keeps its own index of refraction.
void PhotonTree::split_bands(Flight flight, const Arrival& arrival, Rgb flux) {
  flight.band_chosen = true;
  const PathSignature signature = flight.signature;
  for (std::uint32_t band = 0; band < scene_.bands.size(); ++band) {
    flight.band = band;
    flight.signature = in_band(signature, band);
    const Interaction event = interact(scene_, arrival.hit, flight.ray.direction, arrival.media, band);
    go_on(flight, arrival, event, flux * scene_.bands[band].weight);
  }
}

// Take one random direction at a rough face: the same mean as several weaker photons, and no multiplication of photons
// from face to face [O 1.1 row 21].
void PhotonTree::go_on(const Flight& flight, const Arrival& arrival, const Interaction& event, Rgb flux) {
  if (!scene_.plan.roughness || !is_rough(event.roughness)) {
    meet(flight, arrival, event, flux);
    return;
  }
  const auto bounce = static_cast<std::uint64_t>(64 * flight.depth.reflections + flight.depth.transmissions);
  const auto u = padded_4d(within(stream_, bounce), flight.index);
  Interaction one = event;
  roughen(scene_, arrival.hit, flight.ray.direction, arrival.media, {u[0], u[1], u[2]}, Travels::light, one);
  meet(flight, arrival, one, flux);
}

// Store what may be seen here, send the branches on, and enter what ends in the ledger.
void PhotonTree::meet(const Flight& flight, const Arrival& arrival, const Interaction& event, Rgb flux) {
  Rgb left = flux;
  if (event.reflect.exists) {
    const Rgb share = flux * event.reflect.weight;
    left = left - share;
    send(flight, arrival, event.reflect, share);
  }
  if (event.transmit.exists) {
    const Rgb share = flux * event.transmit.weight;
    left = left - share;
    send(flight, arrival, event.transmit, share);
  }
  if (flight.has_bounced() && can_be_diffuse(scene_.materials[event.material])) {
    const PathSignature signature = extended(scene_, flight.signature, arrival, PathStep::end);
    landings_.land({arrival.hit.point, event.facing_normal, flux, left, signature});
    ledger_.stored += left;
  } else {
    ledger_.absorbed += left;
  }
}

void PhotonTree::send(const Flight& from, const Arrival& arrival, const Branch& branch, Rgb flux) {
  Flight next = from;
  next.ray = {arrival.hit.point, branch.direction};
  next.departures = branch.departures;
  next.media = branch.media;
  next.flux = flux;
  next.depth = from.depth.after(branch.lobe);
  next.signature = extended(scene_, from.signature, arrival,
                            branch.lobe == Lobe::transmission ? PathStep::transmit : PathStep::reflect);
  if (!scene_.within_depth(next.depth) || !(largest_channel(flux) >= from.least)) {
    ledger_.truncated += flux;
    return;
  }
  pending_.push_back(next);
}

}  // namespace vitrail
