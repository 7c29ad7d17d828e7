#include "optics/absorption.h"

#include <cmath>

namespace vitrail {

double transmittance(double absorption_per_m, double distance) {
  if (absorption_per_m == 0 || distance == 0) return 1;
  return std::exp(-absorption_per_m * distance);
}

Rgb transmittance(Rgb absorption_per_m, double distance) {
  if (is_black(absorption_per_m)) return {1, 1, 1};
  return {transmittance(absorption_per_m.r, distance), transmittance(absorption_per_m.g, distance),
          transmittance(absorption_per_m.b, distance)};
}

}  // namespace vitrail
