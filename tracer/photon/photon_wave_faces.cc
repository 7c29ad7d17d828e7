/// What happens to the photons of a wave at the faces they meet: absorbed on the way, divided, stored, sent on.

#include <algorithm>

#include "optics/absorption.h"
#include "photon/photon_wave.h"

namespace vitrail {

// Bring the photons of one object and side together, less what the media on their way have kept.
void PhotonWave::arrive(std::int64_t met, const std::vector<std::uint16_t>& rays, std::size_t first) {
  Group& group = *group_;
  group.object = static_cast<std::uint32_t>(met >> 1);
  group.entering = (met & 1) != 0;
  group.count = rays.size();
  const double side = group.entering ? 1 : -1;
  Rgb emitted;
  for (std::size_t i = 0; i < group.count; ++i) {
    const std::size_t ray = rays[i], lane = first + ray;
    const double t = rays_->nearest[ray];
    group.lane[i] = static_cast<std::uint32_t>(lane);
    group.face[i] = rays_->met_face[ray];
    const PhotonState& state = now_.state(lane);
    const Vec3 point = now_.ray(lane).at(t);
    const Rgb flux = now_.flux(lane);
    group.band[i] = state.band;
    for (int a = 0; a < 3; ++a) {
      group.at.point[a][i] = point[a];
      group.flux[a][i] = flux[a];
    }
    if (!state.has_bounced()) emitted += flux;
    if (!anything_absorbs_ || state.medium == kNoObject) continue;
    const Material& medium = *faces_[static_cast<std::size_t>(state.medium)].material;
    const Rgb after = flux * transmittance(medium.absorption_per_m, t);
    block_.ledger.absorbed += flux - after;
    for (int a = 0; a < 3; ++a) group.flux[a][i] = after[a];
  }
  block_.ledger.emitted += emitted;
  objects_.settle(group.object, group.face.data(), static_cast<int>(group.count), group.at);
  for (auto& column : group.at.normal) {
    for (std::size_t i = 0; i < group.count; ++i) column[i] *= side;
  }

  const Face& face = faces_[group.object];
  if (!face.mirrors && !face.transmits) {
    stop(group);
  } else if (face.disperses) {
    divide_by_band(group);
  } else {
    divide(group);
  }
}

// Nothing goes on from a face that is neither mirror nor glass.
void PhotonWave::stop(const Group& group) {
  Rgb stored, absorbed;
  for (std::size_t i = 0; i < group.count; ++i) {
    const Rgb flux = group.flux_of(i);
    if (faces_[group.object].stores && now_.state(group.lane[i]).has_bounced()) {
      block_.photons.push_back(make_photon(pass_.frame, group.point_of(i), group.normal_of(i), flux));
      stored += flux;
    } else {
      absorbed += flux;
    }
  }
  block_.ledger.stored += stored;
  block_.ledger.absorbed += absorbed;
}

// Give each band its weight at the first face that tells bands apart; from there on it keeps its own index.
void PhotonWave::divide_by_band(Group& group) {
  const auto band = group.band;
  const auto flux = group.flux;
  for (std::size_t b = 0; b < scene_.bands.size(); ++b) {
    const Rgb weight = scene_.bands[b].weight;
    for (std::size_t i = 0; i < group.count; ++i) {
      const bool chosen = band[i] >= 0;
      group.band[i] = static_cast<std::int16_t>(b);
      const bool takes_part = !chosen || band[i] == group.band[i];
      for (int c = 0; c < 3; ++c) group.flux[c][i] = takes_part ? flux[c][i] * (chosen ? 1 : weight[c]) : 0;
    }
    divide(group);
  }
}

// Divide the light as `interact` does for one face between air and one glass, or on something opaque.
void PhotonWave::divide(const Group& group) {
  const Face& face = faces_[group.object];
  const Material& material = *face.material;
  BendLanes& bend = *bend_;
  bend.count = group.count;
  bend.normal = group.at.normal;
  for (std::size_t i = 0; i < group.count; ++i) {
    const std::size_t lane = group.lane[i];
    for (int a = 0; a < 3; ++a) bend.direction[a][i] = now_.direction(a)[lane];

    // The index on the arriving side, and behind the face; an opaque mirror has its own.
    const std::size_t band = group.band[i] < 0 ? 0 : static_cast<std::size_t>(group.band[i]);
    double from = 1, from_minus_one = 0;
    double to = material.ior_by_band[band], to_minus_one = material.ior_minus_one_by_band[band];
    if (face.transmits && !group.entering) {
      std::swap(from, to);
      std::swap(from_minus_one, to_minus_one);
    } else if (!face.transmits && now_.state(lane).medium != kNoObject) {
      const Material& around = *faces_[static_cast<std::size_t>(now_.state(lane).medium)].material;
      from = around.ior_by_band[band];
      from_minus_one = around.ior_minus_one_by_band[band];
    }
    bend.ior_from[i] = from;
    bend.ior_to[i] = to;
    bend.ior_step[i] = to_minus_one - from_minus_one;
  }
  refract(bend);
  if (material.fresnel) find_shares(bend);
  bool any_total = false;
  for (std::size_t i = 0; i < bend.count; ++i) any_total = any_total | (bend.radicand[i] < 0);
  if (face.mirrors || material.fresnel || any_total) mirror(bend);

  for (std::size_t i = 0; i < group.count; ++i) {
    const Rgb flux = group.flux_of(i);
    if (is_black(flux)) continue;
    const bool beyond = bend.radicand[i] < 0, total = face.transmits && beyond;
    Rgb mirrored = material.reflection, refracted = material.transmission;
    if (total) {
      mirrored = scene_.paper.tir_drop ? material.reflection : face.pool;
    } else if (material.fresnel) {
      mirrored = face.pool * (beyond ? 1 : bend.share_R[i]);
      refracted = face.pool * (beyond ? 0 : bend.share_T[i]);
    }
    Rgb left = flux;
    if (!is_black(mirrored)) {
      const Rgb share = flux * mirrored;
      left = left - share;
      send(group, i, bend.mirrored, share, false);
    }
    if (face.transmits && !total && !is_black(refracted)) {
      const Rgb share = flux * refracted;
      left = left - share;
      send(group, i, bend.refracted, share, true);
    }
    end(group, i, left);
  }
}

// Store what may be seen here, and book what goes no farther.
void PhotonWave::end(const Group& group, std::size_t i, Rgb left) {
  if (now_.state(group.lane[i]).has_bounced() && faces_[group.object].stores) {
    block_.photons.push_back(make_photon(pass_.frame, group.point_of(i), group.normal_of(i), group.flux_of(i)));
    block_.ledger.stored += left;
  } else {
    block_.ledger.absorbed += left;
  }
}

void PhotonWave::send(const Group& group, std::size_t i, const std::array<BendLanes::Column, 3>& direction, Rgb flux,
                      bool passes) {
  const std::size_t from = group.lane[i];
  PhotonState state = now_.state(from);
  state.reflections = static_cast<std::int16_t>(state.reflections + !passes);
  state.transmissions = static_cast<std::int16_t>(state.transmissions + passes);
  const double least = now_.least(from);
  if (state.reflections > scene_.transport.max_reflections ||
      state.transmissions > scene_.transport.max_transmissions || !(largest_channel(flux) >= least)) {
    block_.ledger.truncated += flux;
    return;
  }
  const auto object = static_cast<std::int32_t>(group.object);
  if (passes) state.medium = group.entering ? object : kNoObject;
  state.departed_face = group.face[i];
  state.band = group.band[i];
  const std::int64_t departed = 2 * static_cast<std::int64_t>(object) + (group.entering == passes ? 1 : 0);
  next_.add(group.point_of(i), {direction[0][i], direction[1][i], direction[2][i]}, flux, least, departed, state);
}

}  // namespace vitrail
