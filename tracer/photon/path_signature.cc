#include "photon/path_signature.h"

#include <cmath>

#include "base/random.h"

namespace vitrail {
namespace {

constexpr std::uint64_t kBands = 1u << 8;  // apart from the steps

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

PathSignature extended(const Scene& scene, PathSignature signature, const Arrival& arrival, PathStep step) {
  Stream name = within(Stream{static_cast<std::uint64_t>(signature)}, static_cast<std::uint64_t>(step));
  for (const Crossing& crossing : arrival.hit.crossings) {
    name = within(within(name, crossing.object), name_of(scene, crossing));
  }
  return PathSignature{name.key};
}

PathSignature in_band(PathSignature signature, std::uint32_t band) {
  return PathSignature{within(Stream{static_cast<std::uint64_t>(signature)}, kBands + band).key};
}

}  // namespace vitrail
