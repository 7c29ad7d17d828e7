#pragma once
/// Photons side by side, a column for each number that loops work on, so that they become vector instructions.

#include <array>
#include <cstdint>
#include <vector>

#include "base/ray.h"
#include "scene/scene.h"

namespace vitrail {

/// No object: the photon did not depart from any, is in air, or meets nothing.
inline constexpr std::int32_t kNoObject = -1;

/// No band yet: the photon has met no face that tells bands apart.
inline constexpr std::int16_t kNoBand = -1;

/// A side of an object: the one that a ray meets, or the one that it departed from.
struct HitId {
  std::int32_t object = kNoObject;
  bool entering = false;  // the ray goes on, or would go on, inside the object

  /// One number per lane, so that loops compare and select: 2 object + entering; negative for no object.
  constexpr std::int64_t lane() const { return object < 0 ? kNoObject : 2 * std::int64_t{object} + (entering ? 1 : 0); }
  static constexpr HitId of_lane(std::int64_t lane) {
    return lane < 0 ? HitId{} : HitId{static_cast<std::int32_t>(lane >> 1), (lane & 1) != 0};
  }
};

/// The part of a photon's state that is whole numbers: no vector loop works on it.
struct DiscreteState {
  std::int32_t departed_face = 0;
  std::int32_t medium = kNoObject;  // the one solid it is in
  std::uint32_t index = 0;          // of the photon in its chart, for random choices at faces
  std::int16_t band = kNoBand;
  std::int16_t reflections = 0, transmissions = 0;

  Depth depth() const { return {reflections, transmissions}; }
  void set_depth(const Depth& depth) {
    reflections = static_cast<std::int16_t>(depth.reflections);
    transmissions = static_cast<std::int16_t>(depth.transmissions);
  }
  bool has_bounced() const { return reflections + transmissions > 0; }
};

/// Photons between two events, as many as there are.
class PathStates {
 public:
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// `least`: W; a branch below this lives by chance, or is cut off. The share is 1.
  void add(Vec3 origin, Vec3 direction, Rgb flux, double least, HitId departed, const DiscreteState& state) {
    if (size_ == room_) grow();
    double* value = values_.data() + size_;
    for (const double v :
         {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, flux.r, flux.g, flux.b, least, 1.0}) {
      *value = v;
      value += room_;
    }
    departed_[size_] = departed.lane();
    states_[size_++] = state;
  }

  /// Make `count` more, to be filled in through the columns from the returned place on.
  std::size_t add_empty(std::size_t count) {
    while (size_ + count > room_) grow();
    const std::size_t first = size_;
    size_ += count;
    return first;
  }
  double* origin(int axis) { return column(axis); }
  double* direction(int axis) { return column(3 + axis); }
  double* flux_column(int channel) { return column(6 + channel); }
  double* least_column() { return column(9); }
  double* share_column() { return column(10); }
  std::int64_t* departed() { return departed_.data(); }
  DiscreteState* states() { return states_.data(); }

  const double* origin(int axis) const { return column(axis); }
  const double* direction(int axis) const { return column(3 + axis); }
  const double* least_column() const { return column(9); }
  /// One HitId::lane each.
  const std::int64_t* departed() const { return departed_.data(); }
  const DiscreteState* states() const { return states_.data(); }

  Ray ray(std::size_t i) const {
    return {{column(0)[i], column(1)[i], column(2)[i]}, {column(3)[i], column(4)[i], column(5)[i]}};
  }
  Rgb flux(std::size_t i) const { return {column(6)[i], column(7)[i], column(8)[i]}; }
  double least(std::size_t i) const { return column(9)[i]; }
  /// Of the photon that left the light, by how it divided at faces.
  double share(std::size_t i) const { return column(10)[i]; }
  const DiscreteState& state(std::size_t i) const { return states_[i]; }

 private:
  static constexpr std::size_t kColumns = 11;

  double* column(int c) { return values_.data() + static_cast<std::size_t>(c) * room_; }
  const double* column(int c) const { return values_.data() + static_cast<std::size_t>(c) * room_; }

  void grow() {
    const std::size_t room = room_ == 0 ? 1024 : 2 * room_;
    std::vector<double> values(kColumns * room);
    for (std::size_t c = 0; c < kColumns; ++c) {
      for (std::size_t i = 0; i < size_; ++i) values[c * room + i] = values_[c * room_ + i];
    }
    values_.swap(values);
    departed_.resize(room);
    states_.resize(room);
    room_ = room;
  }

  std::size_t size_ = 0, room_ = 0;
  std::vector<double> values_;
  std::vector<std::int64_t> departed_;
  std::vector<DiscreteState> states_;
};

/// Some photons of the lanes, and what they meet.
struct RayChunk {
  static constexpr int kCapacity = 256;

  // The rays. Loops read whole vectors: the columns are readable up to the next multiple of eight elements.
  int count = 0;
  std::array<const double*, 3> origin, direction;
  const std::int64_t* departed = nullptr;  // HitId::lane
  const DiscreteState* states = nullptr;

  // The answers: distance of the nearest hit and of the next object's; the nearest one's HitId::lane and face; and
  // whether the two hits are too close together to tell which is first.
  alignas(64) std::array<double, kCapacity> nearest, next;
  alignas(64) std::array<std::int64_t, kCapacity> met, too_close;
  std::array<std::int32_t, kCapacity> met_face;
};

}  // namespace vitrail
