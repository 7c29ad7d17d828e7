#include "photon/photon_tree.h"

#include "material/roughen.h"

namespace vitrail {

void PhotonTree::follow(const LightVertex& start) {
  pending_.clear();
  pending_.push_back(start);
  while (!pending_.empty()) {
    LightVertex photon = pending_.back();
    pending_.pop_back();
    const Arrival arrival = advance(pass_, photon.path);
    if (!photon.has_bounced()) {
      // Leave photons that meet another object to its own chart, or to direct light.
      if (arrival.escaped || arrival.event.object != target_) return;
      ledger_.emitted += photon.path.weight;
    }
    arrive(photon, arrival);
  }
}

void PhotonTree::arrive(LightVertex& photon, const Arrival& arrival) {
  const Rgb sent = photon.path.weight;
  photon.path.weight = sent * arrival.transmittance;
  ledger_.absorbed += sent - photon.path.weight;
  if (arrival.escaped) {
    ledger_.escaped += photon.path.weight;
  } else if (splits_into_bands(scene_, photon.path, arrival.event)) {
    split_bands(photon, arrival);
  } else {
    scatter(photon, arrival, arrival.event);
  }
}

// Give each band its weight of the flux, and that of the bands it stands for; from here on it keeps its own index of
// refraction.
void PhotonTree::split_bands(LightVertex& photon, const Arrival& arrival) {
  photon.path.band_chosen = true;
  const Rgb flux = photon.path.weight;
  const PathSignature signature = photon.signature;
  const BandComb comb = combs_.of(photon.index);
  Rgb taken;
  for (std::uint32_t band = comb.first; band < scene_.bands.size(); band += comb.step) {
    photon.path.band = band;
    photon.path.weight = flux * scene_.bands[band].weight * comb.step;
    photon.signature = in_band(signature, band);
    taken += photon.path.weight;
    scatter(photon, arrival, interact(scene_, incidence_of(photon.path, arrival)));
  }
  if (comb.step > 1) ledger_.emitted += taken - flux;
}

// Take one random direction at a rough face: the same mean as several weaker photons, and no multiplication of photons
// from face to face [O 1.1 row 21].
void PhotonTree::scatter(const LightVertex& photon, const Arrival& arrival, const Interaction& event) {
  if (!scene_.plan.roughness || !is_rough(event.roughness)) {
    divide(photon, arrival, event);
    return;
  }
  const Depth& depth = photon.path.depth;
  const auto bounce = static_cast<std::uint64_t>(64 * depth.reflections + depth.transmissions);
  const auto u = padded_4d(within(stream_, bounce), photon.index);
  Interaction one = event;
  roughen(scene_, incidence_of(photon.path, arrival), {u[0], u[1], u[2]}, Transported::flux, one);
  divide(photon, arrival, one);
}

// Store what may be seen here, send the branches on, and enter what ends in the ledger.
void PhotonTree::divide(const LightVertex& photon, const Arrival& arrival, const Interaction& event) {
  const Rgb flux = photon.path.weight;
  const Rgb reflected = event.reflect.exists ? flux * event.reflect.weight : Rgb{};
  const Rgb transmitted = event.transmit.exists ? flux * event.transmit.weight : Rgb{};
  send_on(photon, arrival, event, {reflected, transmitted});
  const Rgb left = flux - reflected - transmitted;
  if (photon.has_bounced() && can_be_diffuse(scene_.materials[event.material])) {
    const PathSignature signature = extended(scene_, photon.signature, arrival, PathStep::end);
    landings_.land({arrival.hit.point, event.facing_normal, flux, left, signature});
    ledger_.stored += left;
  } else {
    ledger_.absorbed += left;
  }
}

// Follow the ways that are within the limits, as many as matter. What chance takes or adds counts as not emitted, or
// as emitted, so that the ledger closes.
void PhotonTree::send_on(const LightVertex& photon, const Arrival& arrival, const Interaction& event,
                         DividedFlux flux) {
  const Depth& depth = photon.path.depth;
  const WaysOn ways = branches_.choose({photon.share, photon.least, photon.index, depth}, flux);
  const std::array<const Branch*, 2> branches{&event.reflect, &event.transmit};
  for (std::size_t way = 0; way < 2; ++way) {
    if (!branches[way]->exists) continue;
    const Rgb sent = flux[way] * ways.factor[way];
    if (branches_.follow_every_way()) {
      ledger_.truncated += flux[way] - sent;
    } else if (ways.factor[way] != 1) {
      ledger_.emitted += sent - flux[way];
    }
    if (is_black(sent)) continue;
    if (scene_.within_depth(depth.after(branches[way]->lobe))) {
      send(photon, arrival, *branches[way], sent, ways.share[way]);
    } else {
      ledger_.truncated += sent;
    }
  }
}

void PhotonTree::send(const LightVertex& from, const Arrival& arrival, const Branch& branch, Rgb flux, double share) {
  LightVertex& next = pending_.emplace_back(from);
  next.path.ray = {arrival.hit.point, branch.direction};
  next.path.departures = branch.departures;
  next.path.media = branch.media;
  next.path.weight = flux;
  next.path.depth = from.path.depth.after(branch.lobe);
  next.share = share;
  next.signature = extended(scene_, from.signature, arrival,
                            branch.lobe == Lobe::transmission ? PathStep::transmit : PathStep::reflect);
}

}  // namespace vitrail
