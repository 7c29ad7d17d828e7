#include "photon/way.h"

#include <cmath>

#include "base/random.h"

namespace vitrail {
namespace {

constexpr std::uint64_t kBands = 1u << 8;  // apart from the turns

// Two triangles of one plane have the same normal but for rounding.
constexpr double kNormalSteps = 1e6;

std::uint64_t name_of(const Scene& scene, const Crossing& crossing) {
  const auto* mesh = std::get_if<MeshShape>(&scene.objects[crossing.object].shape);
  if (mesh == nullptr) return crossing.face;
  if (mesh->smooth) return 0;
  Stream name{0};
  for (const double c : {crossing.normal.x, crossing.normal.y, crossing.normal.z}) {
    name = within(name, static_cast<std::uint64_t>(std::llround(c * kNormalSteps)));
  }
  return name.key;
}

}  // namespace

std::uint64_t on_the_way(const Scene& scene, std::uint64_t way, const Arrival& arrival, Turn turn) {
  Stream name = within(Stream{way}, static_cast<std::uint64_t>(turn));
  for (const Crossing& crossing : arrival.hit.crossings) {
    name = within(within(name, crossing.object), name_of(scene, crossing));
  }
  return name.key;
}

std::uint64_t in_band(std::uint64_t way, std::uint32_t band) { return within(Stream{way}, kBands + band).key; }

}  // namespace vitrail
