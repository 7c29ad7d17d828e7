#include "photon/photon_wave.h"

#include <algorithm>

#include "optics/absorption.h"
#include "optics/fresnel.h"
#include "optics/refract.h"

namespace vitrail {
namespace {

// Two surfaces this close together, relative to the coordinates, are left to the exact search.
constexpr double kTooClose = 0x1p-30;

bool is_smooth(const Material& material) { return std::holds_alternative<NoRoughness>(material.roughness); }

}  // namespace

bool PhotonWave::suits(const Scene& scene) {
  const bool smooth = std::all_of(scene.materials.begin(), scene.materials.end(), is_smooth);
  return smooth && FewObjects::suit(scene);
}

PhotonWave::PhotonWave(const PhotonPass& pass, std::uint32_t target, PhotonBlock& block)
    : pass_(pass),
      scene_(pass.scene),
      target_(target),
      block_(block),
      objects_(pass.scene),
      tree_(pass, target, block) {
  for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
    const Object& object = scene_.objects[i];
    const Material& material = scene_.material_of(i);
    Face face;
    face.transmits = material.transmits();
    face.is_sheet =
        std::holds_alternative<RectangleShape>(object.shape) || std::holds_alternative<DiscShape>(object.shape);
    face.stores = can_be_diffuse(material);
    face.disperses = tells_bands_apart(scene_, i);
    face.absorbs = !is_black(material.absorption_per_m);
    face.priority = object.priority;
    face.material = &material;
    faces_.push_back(face);
  }
}

void PhotonWave::add(const Ray& ray, const MediumSet& media, Rgb flux) {
  Traveller photon;
  photon.ray = ray;
  photon.flux = flux;
  photon.least = kLeastPhotonShare * largest_channel(flux);
  if (media.size() > 1) {
    Flight flight{ray, {}, media, flux, photon.least};
    tree_.follow(flight);
    return;
  }
  if (media.size() == 1) photon.medium = media[0];
  pending_.push_back(photon);
  if (pending_.size() >= RayLanes::kCapacity) step();
}

void PhotonWave::finish() {
  while (!pending_.empty()) step();
}

// Take the latest photons, find what they meet, and let each arrive; branches join the photons that wait.
void PhotonWave::step() {
  const std::size_t count = std::min<std::size_t>(RayLanes::kCapacity, pending_.size());
  at_hand_.assign(pending_.end() - static_cast<std::ptrdiff_t>(count), pending_.end());
  pending_.resize(pending_.size() - count);
  lanes_.count = static_cast<int>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Traveller& photon = at_hand_[i];
    lanes_.origin_x[i] = photon.ray.origin.x;
    lanes_.origin_y[i] = photon.ray.origin.y;
    lanes_.origin_z[i] = photon.ray.origin.z;
    lanes_.direction_x[i] = photon.ray.direction.x;
    lanes_.direction_y[i] = photon.ray.direction.y;
    lanes_.direction_z[i] = photon.ray.direction.z;
    lanes_.departed[i] = photon.departed;
    lanes_.departed_face[i] = photon.departed_face;
  }
  objects_.find(lanes_);
  for (std::size_t i = 0; i < count; ++i) arrive(at_hand_[i], static_cast<int>(i));
}

// In air meeting anything, or inside one glass meeting its own face or something opaque that it does not displace.
bool PhotonWave::is_plain(const Traveller& photon, std::uint32_t object, bool entering) const {
  const Face& face = faces_[object];
  if (face.transmits) return !face.is_sheet && photon.medium == (entering ? kAir : object);
  return photon.medium == kAir || faces_[photon.medium].priority <= face.priority;
}

void PhotonWave::arrive(const Traveller& photon, int lane) {
  const double t = lanes_.nearest[lane];
  const bool escapes = lanes_.met[lane] == RayLanes::kNone;
  Meeting meeting;
  if (!escapes) {
    meeting.object = static_cast<std::uint32_t>(lanes_.met[lane] >> 1);
    meeting.entering = (lanes_.met[lane] & 1) != 0;
    meeting.face = static_cast<std::uint32_t>(lanes_.met_face[lane]);
    const double window = (largest_coordinate(photon.ray.origin) + t) * kTooClose;
    if (lanes_.next[lane] - t <= window || !is_plain(photon, meeting.object, meeting.entering)) {
      follow_generally(photon);
      return;
    }
  }
  if (!photon.has_bounced()) {
    // Leave photons that meet another object to its own chart, or to direct light.
    if (escapes || meeting.object != target_) return;
    block_.ledger.emitted += photon.flux;
  }

  // Take off what the medium keeps.
  Rgb flux = photon.flux;
  if (photon.medium != kAir && faces_[photon.medium].absorbs) {
    flux *= transmittance(faces_[photon.medium].material->absorption_per_m, t);
    block_.ledger.absorbed += photon.flux - flux;
  }
  if (escapes) {
    block_.ledger.escaped += flux;
    return;
  }
  meeting.at = objects_.surface(meeting.object, photon.ray.at(t), meeting.face);
  const Face& face = faces_[meeting.object];
  meeting.medium_after = !face.transmits ? photon.medium : meeting.entering ? meeting.object : kAir;
  meet(photon, meeting, flux);
}

// Divide the light as `interact` does for one face between air and one glass, or on something opaque.
void PhotonWave::meet(const Traveller& photon, const Meeting& meeting, Rgb flux) {
  const Face& face = faces_[meeting.object];
  const Material& material = *face.material;
  Rgb left = flux, mirrored = material.reflection, refracted = material.transmission;
  const Vec3 normal = meeting.entering ? meeting.at.normal : -meeting.at.normal;
  Refraction refraction;
  if (face.transmits || material.fresnel) {
    const auto band = static_cast<std::size_t>(photon.band);
    const double n = material.ior_by_band[band], n_minus_one = material.ior_minus_one_by_band[band];
    IndexPair index{1, n, 0, n_minus_one};
    if (!meeting.entering && face.transmits) index = {n, 1, n_minus_one, 0};
    if (!face.transmits && photon.medium != kAir) {
      const Material& around = *faces_[photon.medium].material;
      index = {around.ior_by_band[band], n, around.ior_minus_one_by_band[band], n_minus_one};
    }
    refraction = scene_.paper.refraction_literal ? refract_literal(photon.ray.direction, normal, index)
                                                 : refract(photon.ray.direction, normal, index);
    const Rgb pool = material.reflection + material.transmission;
    if (face.transmits && refraction.total) {
      mirrored = scene_.paper.tir_drop ? material.reflection : pool;
    } else if (material.fresnel) {
      const FresnelShares shares = fresnel(index, refraction);
      mirrored = pool * shares.R;
      refracted = pool * shares.T;
    }
  }
  const bool transmits = face.transmits && !refraction.total && !is_black(refracted);

  // Give each band its weight at the first face that tells bands apart; from here on it keeps its own index.
  if (transmits && face.disperses && !photon.band_chosen) {
    Traveller one = photon;
    one.band_chosen = true;
    for (std::size_t band = 0; band < scene_.bands.size(); ++band) {
      one.band = static_cast<std::int32_t>(band);
      meet(one, meeting, flux * scene_.bands[band].weight);
    }
    return;
  }
  if (!is_black(mirrored)) {
    left = left - flux * mirrored;
    send(photon, meeting, reflect(photon.ray.direction, normal), flux * mirrored, false);
  }
  if (transmits) {
    left = left - flux * refracted;
    send(photon, meeting, refraction.direction, flux * refracted, true);
  }
  if (photon.has_bounced() && face.stores) {
    block_.photons.push_back(make_photon(pass_.frame, meeting.at.point, normal, flux));
    block_.ledger.stored += left;
  } else {
    block_.ledger.absorbed += left;
  }
}

void PhotonWave::send(const Traveller& from, const Meeting& meeting, Vec3 direction, Rgb flux, bool passes) {
  const int reflections = from.reflections + !passes, transmissions = from.transmissions + passes;
  if (reflections > scene_.transport.max_reflections || transmissions > scene_.transport.max_transmissions ||
      !(largest_channel(flux) >= from.least)) {
    block_.ledger.truncated += flux;
    return;
  }
  Traveller next = from;
  next.ray = {meeting.at.point, direction};
  next.flux = flux;
  next.departed = 2 * static_cast<std::int64_t>(meeting.object) + (meeting.entering == passes ? 1 : 0);
  next.departed_face = meeting.face;
  next.medium = passes ? meeting.medium_after : from.medium;
  next.reflections = static_cast<std::int16_t>(reflections);
  next.transmissions = static_cast<std::int16_t>(transmissions);
  pending_.push_back(next);
}

void PhotonWave::follow_generally(const Traveller& photon) {
  Flight flight;
  flight.ray = photon.ray;
  if (photon.departed != RayLanes::kNone) {
    flight.departures.push_back(
        {static_cast<std::uint32_t>(photon.departed >> 1), photon.departed_face, (photon.departed & 1) != 0});
  }
  if (photon.medium != kAir) flight.media.enter(photon.medium);
  flight.flux = photon.flux;
  flight.least = photon.least;
  flight.band = static_cast<std::uint32_t>(photon.band);
  flight.band_chosen = photon.band_chosen;
  flight.reflections = photon.reflections;
  flight.transmissions = photon.transmissions;
  tree_.follow(flight);
}

}  // namespace vitrail
