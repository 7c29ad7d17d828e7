#pragma once
/// All surfaces of a scene, ready to be asked by rays. The only door to Embree.

#include <cstdint>
#include <memory>

#include "base/ray.h"
#include "geometry/bounds.h"
#include "geometry/hit.h"
#include "geometry/medium_stack.h"
#include "scene/scene.h"

namespace vitrail {

/// Which search is used; `automatic` takes the plain list for at most 8 primitives. Both give identical hits.
enum class Search { automatic, list, embree };

/// Every decision in double: the same hit for either search, any order of objects, and any scale 2^k.
/// Const calls are safe from many threads at once.
class Intersector {
 public:
  /// The scene must outlive the intersector. Throws InputError if a mesh file cannot be used.
  explicit Intersector(const Scene& scene, Search search = Search::automatic);
  ~Intersector();
  Intersector(Intersector&&) noexcept;
  Intersector& operator=(Intersector&&) noexcept;

  /// The nearest hit beyond what the ray departs from, or false if the ray escapes.
  bool closest(const Ray& ray, const Departures& departures, Hit& hit) const;

  /// Whether any surface lies strictly between the origin and t_max along the ray (infinity for a directional light).
  bool occluded(const Ray& ray, const Departures& departures, double t_max) const;

  /// The transmissive solids that contain a point: where a camera or light ray starts. Opaque solids count as hollow,
  /// so that a box may be a room.
  MediumSet media_at(Vec3 point) const;

  /// The box around all finite shapes; empty if there is none.
  Bounds bounds() const;
  /// The box around one object; infinite planes give infinite boxes.
  Bounds object_bounds(std::uint32_t object) const;
  std::uint64_t primitive_count() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vitrail
