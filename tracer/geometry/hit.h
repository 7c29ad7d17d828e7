#pragma once
/// Where a ray meets surfaces, and what it must not meet again right after.

#include <array>
#include <cstdint>

#include "base/vec3.h"

namespace vitrail {

/// A face the ray stands on: never hit again at distance zero. Curved faces may be hit at their other root.
struct Departure {
  std::uint32_t object = 0;
  std::uint32_t face = 0;  // numbered by the shape; the triangle of a mesh
  bool inside = false;     // the ray goes on inside the solid (for a sheet: on the side against its normal)
};

/// A few values in place: the faces that coincide in one point are a handful. What exceeds the capacity is dropped.
template <typename Value, int capacity>
class InlineVector {
 public:
  InlineVector() = default;
  /// Copy what is there and not the empty places: these values are on the way of every ray.
  InlineVector(const InlineVector& other) { *this = other; }
  InlineVector& operator=(const InlineVector& other) {
    size_ = other.size_;
    for (int i = 0; i < size_; ++i) values_[i] = other.values_[i];
    return *this;
  }

  const Value* begin() const { return values_.data(); }
  const Value* end() const { return values_.data() + size_; }
  Value* begin() { return values_.data(); }
  Value* end() { return values_.data() + size_; }
  int size() const { return size_; }
  void clear() { size_ = 0; }
  void push_back(const Value& value) {
    if (size_ < capacity) values_[size_++] = value;
  }
  const Value& operator[](int index) const { return values_[index]; }
  Value& operator[](int index) { return values_[index]; }

 private:
  std::array<Value, capacity> values_;
  int size_ = 0;
};

using Departures = InlineVector<Departure, 6>;

/// What a ray departs from on one object; null if it does not stand on it.
inline const Departure* departure_of(const Departures& departures, std::uint32_t object) {
  for (const Departure& left : departures)
    if (left.object == object) return &left;
  return nullptr;
}

/// One surface met at a hit.
struct Crossing {
  double t = 0;
  std::uint32_t object = 0;
  std::uint32_t face = 0;
  bool entering = false;  // from the side the outward normal points to
  bool counted = false;   // a mesh: its shells may overlap each other
  double s = 0, q = 0;    // surface coordinates of flat shapes, metres
  Vec3 normal;            // geometric, unit, outward
  Vec3 shading_normal;    // equal to normal except on smooth meshes
};

using Crossings = InlineVector<Crossing, 6>;

/// The nearest surface and everything that coincides with it within rounding, by object and not by order of arrival:
/// what a ray meets in a point does not depend on the order of objects that touch there.
struct Hit {
  double t = 0;
  Vec3 point;           // of the nearest, projected back onto its surface
  Crossings crossings;  // at least one

  /// What to leave behind when light stays on the side it came from (reflect, scatter, shadow rays) ...
  Departures back() const { return leave(false); }
  /// ... and when it goes through.
  Departures through() const { return leave(true); }

 private:
  Departures leave(bool pass) const {
    Departures result;
    for (const Crossing& c : crossings) result.push_back({c.object, c.face, c.entering == pass});
    return result;
  }
};

}  // namespace vitrail
