#include "photon/trace.h"

#include <algorithm>

namespace vitrail {
namespace {

// A photon between two events.
struct Flight {
  Ray ray;
  Departures departures;
  MediumSet media;
  Rgb flux;
  std::uint32_t band = 0;
  bool band_chosen = false;  // before the first dispersive face every band takes the same way
  int reflections = 0, transmissions = 0;
};

bool can_be_diffuse(const Material& material) { return !is_black(texture_peak(material.diffuse)); }

// The tree of one photon, with everything booked as shares of flux.
class PhotonTree {
 public:
  PhotonTree(const PhotonPass& pass, std::uint32_t target, PhotonBlock& block)
      : pass_(pass), scene_(pass.scene), target_(target), block_(block) {}

  void follow(const Ray& ray, const MediumSet& media, Rgb flux) {
    least_ = kLeastPhotonShare * largest_channel(flux);
    pending_.clear();
    pending_.push_back({ray, {}, media, flux});
    bool first = true;
    while (!pending_.empty()) {
      const Flight flight = pending_.back();
      pending_.pop_back();
      const Arrival arrival =
          advance(scene_, pass_.intersector, flight.ray, flight.departures, flight.media, flight.band);
      if (first) {
        // Leave photons that meet another object to its own chart, or to direct light.
        if (arrival.escaped || arrival.event.object != target_) return;
        block_.ledger.emitted += flux;
        first = false;
      }
      arrive(flight, arrival);
    }
  }

 private:
  void arrive(const Flight& flight, const Arrival& arrival) {
    const Rgb flux = flight.flux * arrival.transmittance;
    block_.ledger.absorbed += flight.flux - flux;
    if (arrival.escaped) {
      block_.ledger.escaped += flux;
      return;
    }
    const bool bounced = flight.reflections + flight.transmissions > 0;
    if (!flight.band_chosen && disperses(arrival.event)) {
      split_bands(flight, arrival, flux, bounced);
    } else {
      meet(flight, arrival, arrival.event, flux, bounced);
    }
  }

  bool disperses(const Interaction& event) const {
    if (scene_.bands.size() < 2 || !event.transmit.exists) return false;
    return disperses_in(event.medium_before) || disperses_in(event.medium_after);
  }

  bool disperses_in(std::uint32_t object) const {
    if (object == kAir) return false;
    const auto& ior = scene_.material_of(object).ior_by_band;
    return std::any_of(ior.begin(), ior.end(), [&](double n) { return n != ior[0]; });
  }

  // Give each band its weight of the flux; from here on it keeps its own index of refraction.
  void split_bands(Flight flight, const Arrival& arrival, Rgb flux, bool bounced) {
    flight.band_chosen = true;
    for (std::uint32_t band = 0; band < scene_.bands.size(); ++band) {
      flight.band = band;
      const Interaction event = interact(scene_, arrival.hit, flight.ray.direction, arrival.media, band);
      meet(flight, arrival, event, flux * scene_.bands[band].weight, bounced);
    }
  }

  // Store what may be seen here, send the branches on, and book what ends.
  void meet(const Flight& flight, const Arrival& arrival, const Interaction& event, Rgb flux, bool bounced) {
    Rgb left = flux;
    if (event.reflect.exists) {
      const Rgb share = flux * event.reflect.weight;
      left = left - share;
      send(flight, arrival, event.reflect, share, 1, 0);
    }
    if (event.transmit.exists) {
      const Rgb share = flux * event.transmit.weight;
      left = left - share;
      send(flight, arrival, event.transmit, share, 0, 1);
    }
    if (bounced && can_be_diffuse(scene_.materials[event.material])) {
      block_.photons.push_back(make_photon(pass_.frame, arrival.hit.point, event.facing_normal, flux));
      block_.ledger.stored += left;
    } else {
      block_.ledger.absorbed += left;
    }
  }

  void send(const Flight& from, const Arrival& arrival, const Branch& branch, Rgb flux, int reflections,
            int transmissions) {
    Flight next{{arrival.hit.point, branch.direction},
                branch.departures,
                branch.media,
                flux,
                from.band,
                from.band_chosen,
                from.reflections + reflections,
                from.transmissions + transmissions};
    if (next.reflections > scene_.transport.max_reflections ||
        next.transmissions > scene_.transport.max_transmissions || !(largest_channel(flux) >= least_)) {
      block_.ledger.truncated += flux;
      return;
    }
    pending_.push_back(next);
  }

  const PhotonPass& pass_;
  const Scene& scene_;
  std::uint32_t target_;
  PhotonBlock& block_;
  double least_ = 0;
  std::vector<Flight> pending_;
};

}  // namespace

PhotonBlock trace_photons(const PhotonPass& pass, const Chart& chart, Stream stream, std::uint64_t first,
                          std::uint64_t count) {
  PhotonBlock block;
  block.photons.reserve(count);
  PhotonTree tree(pass, chart.target, block);
  const double share = 1 / static_cast<double>(chart.count);
  MediumSet media;
  Vec3 media_position;
  bool media_known = false;
  for (std::uint64_t i = first; i < first + count; ++i) {
    const Emission emission = emit(chart, sobol_4d(stream, static_cast<std::uint32_t>(i)));
    if (is_black(emission.power)) continue;

    // Ask which solids contain the start once for all photons of one place.
    if (!media_known || !(emission.ray.origin == media_position)) {
      media_position = emission.ray.origin;
      media = pass.intersector.media_at(media_position);
      media_known = true;
    }
    tree.follow(emission.ray, media, emission.power * share);
  }
  return block;
}

}  // namespace vitrail
