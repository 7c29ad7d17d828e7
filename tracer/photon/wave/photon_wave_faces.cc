/// What happens to the photons of a wave at the faces they meet: absorbed on the way, divided, stored, sent on.

#include <utility>

#include "optics/absorption.h"
#include "photon/wave/photon_wave.h"

namespace vitrail {

// Bring the photons of one object and side together, less what the media on their way have kept.
void PhotonWave::arrive(HitId met, const std::vector<std::uint16_t>& rays, std::size_t first) {
  Group& group = *group_;
  group.met = met;
  group.count = rays.size();
  const double side = met.entering ? 1 : -1;
  Rgb emitted;
  for (std::size_t i = 0; i < group.count; ++i) {
    const std::size_t ray = rays[i], lane = first + ray;
    const double t = rays_->nearest[ray];
    group.lane[i] = static_cast<std::uint32_t>(lane);
    group.face[i] = rays_->met_face[ray];
    const DiscreteState& state = now_.state(lane);
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
  objects_.settle(static_cast<std::uint32_t>(met.object), group.face.data(), static_cast<int>(group.count), group.at);
  for (auto& column : group.at.normal) {
    for (std::size_t i = 0; i < group.count; ++i) column[i] *= side;
  }

  const Face& face = face_of(group);
  if (!face.mirrors && !face.transmits) {
    stop(group);
  } else if (face.disperses && group.band[0] == kNoBand) {
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
    if (face_of(group).stores && now_.state(group.lane[i]).has_bounced()) {
      store(group, i);
      stored += flux;
    } else {
      absorbed += flux;
    }
  }
  block_.ledger.stored += stored;
  block_.ledger.absorbed += absorbed;
}

// Give each band its weight at the first face that tells bands apart, and that of the bands it stands for; from there
// on it keeps its own index.
void PhotonWave::divide_by_band(Group& group) {
  const auto flux = group.flux;
  const auto count = static_cast<std::uint32_t>(scene_.bands.size());
  std::array<std::uint32_t, RayChunk::kCapacity> band;
  for (std::size_t i = 0; i < group.count; ++i) band[i] = combs_.of(now_.state(group.lane[i]).index).first;
  Rgb taken;
  for (std::uint32_t done = 0; done < count; done += combs_.step()) {
    for (std::size_t i = 0; i < group.count; ++i) {
      const bool exists = band[i] < count;
      const std::uint32_t own = exists ? band[i] : 0;
      const Rgb weight = exists ? scene_.bands[own].weight * combs_.step() : Rgb{};
      group.band[i] = static_cast<std::int16_t>(own);
      for (int c = 0; c < 3; ++c) group.flux[c][i] = flux[c][i] * weight[c];
      taken += group.flux_of(i);
      band[i] += combs_.step();
    }
    divide(group);
  }
  if (combs_.step() == 1) return;
  for (std::size_t i = 0; i < group.count; ++i) taken = taken - Rgb{flux[0][i], flux[1][i], flux[2][i]};
  block_.ledger.emitted += taken;
}

// Find the ways on from a face between air and one glass, or on something opaque.
void PhotonWave::find_lobes(const Group& group) {
  const Face& face = face_of(group);
  const Material& material = *face.material;
  DielectricLanes& lanes = *lanes_;
  lanes.count = group.count;
  lanes.normal = group.at.normal;
  for (int a = 0; a < 3; ++a) {
    const double* const direction = std::as_const(now_).direction(a);
    for (std::size_t i = 0; i < group.count; ++i) lanes.direction[a][i] = direction[group.lane[i]];
  }

  // The index on the arriving side, and behind the face; an opaque mirror has its own.
  for (std::size_t i = 0; i < group.count; ++i) {
    const std::size_t band = group.band[i] == kNoBand ? 0 : static_cast<std::size_t>(group.band[i]);
    const double own = material.ior_by_band[band], own_minus_one = material.ior_minus_one_by_band[band];
    const bool leaves = face.transmits && !group.met.entering;
    lanes.ior_from[i] = leaves ? own : 1;
    lanes.ior_to[i] = leaves ? 1 : own;
    lanes.ior_step[i] = leaves ? -own_minus_one : own_minus_one;
    const std::int32_t around = now_.state(group.lane[i]).medium;
    if (face.transmits || around == kNoObject) continue;
    const Material& medium = *faces_[static_cast<std::size_t>(around)].material;
    lanes.ior_from[i] = medium.ior_by_band[band];
    lanes.ior_step[i] = own_minus_one - medium.ior_minus_one_by_band[band];
  }
  refract(lanes);
  if (material.fresnel) find_fresnel_shares(lanes);
}

// Divide the light, send on what there is, and end the rest here.
void PhotonWave::divide(const Group& group) {
  block_.divisions += group.count;
  const Face& face = face_of(group);
  find_lobes(group);
  if (face.rough) draw(group);
  mirrored_.goes_on = refracted_.goes_on = false;
  if (face.rough && std::holds_alternative<Ggx>(face.material->roughness)) {
    divide_at_facets(group);
  } else {
    divide_at_plane(group);
  }
  end(group);
  choose_ways(group);
  if (mirrored_.goes_on) send(group, mirrored_);
  if (refracted_.goes_on) send(group, refracted_);
}

// Divide as `interact` does: a fixed share each way, or the pool by Fresnel; all of the pool where the reflection is
// total.
void PhotonWave::divide_at_plane(const Group& group) {
  const Face& face = face_of(group);
  const Material& material = *face.material;
  DielectricLanes& lanes = *lanes_;
  const bool glass = face.transmits, by_fresnel = material.fresnel;
  const bool drops = glass && scene_.paper.tir_drop, has_fixed_shares = !glass && !by_fresnel;
  const Rgb beyond = drops || has_fixed_shares ? material.reflection : face.pool;
  for (int c = 0; c < 3; ++c) {
    const double pool = face.pool[c], r = material.reflection[c], t = glass ? material.transmission[c] : 0;
    const double beyond_c = beyond[c];
    const double* const flux = group.flux[c].data();
    for (std::size_t i = 0; i < group.count; ++i) {
      const bool total = lanes.radicand[i] < 0;
      const double mirrored = total ? beyond_c : by_fresnel ? pool * lanes.share_R[i] : r;
      const double refracted = total || !glass ? 0.0 : by_fresnel ? pool * lanes.share_T[i] : t;
      mirrored_.flux[c][i] = flux[i] * mirrored;
      refracted_.flux[c][i] = flux[i] * refracted;
    }
  }

  // What a dielectric interface reflects is total internal reflection where nothing is refracted.
  bool any_total = false;
  for (std::size_t i = 0; i < group.count; ++i) {
    const bool total = lanes.radicand[i] < 0;
    any_total = any_total | total;
    mirrored_.lobe[i] = total && glass && !drops ? Lobe::total_internal_reflection : Lobe::reflection;
    refracted_.lobe[i] = Lobe::transmission;
  }
  if (face.mirrors || by_fresnel || any_total) {
    reflect(lanes);
    mirrored_.direction = &lanes.mirrored;
    if (face.rough) deflect_part(group, mirrored_, 1);
    mirrored_.goes_on = true;
  }
  if (glass) {
    refracted_.direction = &lanes.refracted;
    if (face.rough) deflect_part(group, refracted_, -1);
    refracted_.goes_on = true;
  }
}

void PhotonWave::store(const Group& group, std::size_t i) {
  block_.photons.push_back(make_photon(pass_.frame, group.point_of(i), group.normal_of(i), group.flux_of(i)));
}

// Store what may be seen here, and enter what goes no farther in the ledger.
void PhotonWave::end(const Group& group) {
  const bool stores = face_of(group).stores;
  Rgb stored, absorbed;
  for (std::size_t i = 0; i < group.count; ++i) {
    const Rgb left = group.flux_of(i) - mirrored_.flux_of(i) - refracted_.flux_of(i);
    if (stores && now_.state(group.lane[i]).has_bounced() && !is_black(group.flux_of(i))) {
      store(group, i);
      stored += left;
    } else {
      absorbed += left;
    }
  }
  block_.ledger.stored += stored;
  block_.ledger.absorbed += absorbed;
}

// Leave weak ways to chance, as PhotonTree does.
void PhotonWave::choose_ways(const Group& group) {
  Rgb by_chance, truncated;
  for (std::size_t i = 0; i < group.count; ++i) {
    const std::size_t lane = group.lane[i];
    const DiscreteState& state = now_.state(lane);
    const DividedFlux flux{mirrored_.flux_of(i), refracted_.flux_of(i)};
    const WaysOn ways = branches_.choose({now_.share(lane), now_.least(lane), state.index, state.depth()}, flux);
    mirrored_.share[i] = ways.share[0];
    refracted_.share[i] = ways.share[1];
    if (ways.factor[0] == 1 && ways.factor[1] == 1) continue;
    for (std::size_t way = 0; way < 2; ++way) {
      const Rgb sent = flux[way] * ways.factor[way];
      (way == 0 ? mirrored_ : refracted_).set_flux(i, sent);
      (branches_.follow_every_way() ? truncated : by_chance) += sent - flux[way];
    }
  }
  block_.ledger.emitted += by_chance;
  block_.ledger.truncated = block_.ledger.truncated - truncated;
}

// Choose the branches with flux and depth left; what is too deep is truncated.
void PhotonWave::choose_survivors(const Group& group, const Part& part, Survivors& survivors) {
  survivors.count = 0;
  for (std::size_t i = 0; i < group.count; ++i) {
    const Rgb flux = part.flux_of(i);
    const bool goes_on = scene_.within_depth(now_.state(group.lane[i]).depth().after(part.lobe[i]));
    survivors.lane[survivors.count] = static_cast<std::uint16_t>(i);
    survivors.count += goes_on && largest_channel(flux) > 0;
    if (!goes_on) block_.ledger.truncated += flux;
  }
}

// Let the branches of one part join the next generation, column by column.
void PhotonWave::send(const Group& group, const Part& part) {
  Survivors kept;
  choose_survivors(group, part, kept);
  const std::size_t first = next_.add_empty(kept.count);
  for (int a = 0; a < 3; ++a) {
    double *const origin_to = next_.origin(a) + first, *const direction_to = next_.direction(a) + first;
    double* const flux_to = next_.flux_column(a) + first;
    for (std::size_t k = 0; k < kept.count; ++k) {
      origin_to[k] = group.at.point[a][kept.lane[k]];
      direction_to[k] = (*part.direction)[a][kept.lane[k]];
      flux_to[k] = part.flux[a][kept.lane[k]];
    }
  }
  const std::int32_t medium = group.met.entering ? group.met.object : kNoObject;
  const double* const least = std::as_const(now_).least_column();
  for (std::size_t k = 0; k < kept.count; ++k) {
    const std::size_t i = kept.lane[k], from = group.lane[i];
    const bool passes = part.lobe[i] == Lobe::transmission;
    DiscreteState state = now_.state(from);
    state.set_depth(state.depth().after(part.lobe[i]));
    if (passes) state.medium = medium;
    state.departed_face = group.face[i];
    state.band = group.band[i];
    next_.least_column()[first + k] = least[from];
    next_.share_column()[first + k] = part.share[i];
    next_.departed()[first + k] = HitId{group.met.object, group.met.entering == passes}.lane();
    next_.states()[first + k] = state;
  }
}

}  // namespace vitrail
