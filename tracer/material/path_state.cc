#include "material/path_state.h"

#include <algorithm>

namespace vitrail {

bool is_dispersive(const Scene& scene, std::uint32_t object) {
  if (object == kAir || scene.bands.size() < 2) return false;
  const auto& ior = scene.material_of(object).ior_by_band;
  return std::any_of(ior.begin(), ior.end(), [&](double n) { return n != ior[0]; });
}

}  // namespace vitrail
