#pragma once
/// Beer-Lambert: what is left of light after a way through a medium.

#include "base/vec3.h"

namespace vitrail {

/// exp(-a L). No absorption leaves everything on an infinite way; an infinite absorption leaves nothing on any way
/// longer than zero [O 2.36].
double transmittance(double absorption_per_m, double distance);
Rgb transmittance(Rgb absorption_per_m, double distance);

}  // namespace vitrail
